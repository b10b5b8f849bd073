#include <opal/localization/events/event_stream.hpp>

#include <catch2/catch.hpp>

#include <limits>
#include <sstream>

using nlohmann::ordered_json;

TEST_CASE("an event is one line, with its members in the order they were given") {
  std::ostringstream out;
  opal::JsonLinesSink sink(out);
  sink.write({{"event", "spawned"}, {"stamp_s", 1.5}, {"keyframe", 3}});
  sink.write({{"event", "pruned"}, {"reason", "two\nlines"}});
  CHECK(out.str() ==
        "{\"event\":\"spawned\",\"stamp_s\":1.5,\"keyframe\":3}\n"
        "{\"event\":\"pruned\",\"reason\":\"two\\nlines\"}\n");
}

TEST_CASE("numbers in events have at most six decimals, at any depth") {
  std::ostringstream out;
  opal::JsonLinesSink sink(out);
  sink.write({{"a", 1.0 / 3}, {"b", {{"c", ordered_json::array({2e-9, -1.23456789})}}}, {"n", 12345678901LL}});
  CHECK(out.str() == "{\"a\":0.333333,\"b\":{\"c\":[0.0,-1.234568]},\"n\":12345678901}\n");
}

TEST_CASE("events survive NaN, infinity, huge numbers and bytes that are no UTF-8") {
  std::ostringstream out;
  opal::JsonLinesSink sink(out);
  const double infinity = std::numeric_limits<double>::infinity();
  sink.write({{"nan", std::nan("")}, {"infinite", -infinity}, {"huge", 1e300}, {"text", "\xff"}});
  const auto read = ordered_json::parse(out.str());
  CHECK(read["nan"].is_null());
  CHECK(read["infinite"].is_null());
  CHECK(read["huge"] == 1e300);
}

TEST_CASE("a sink that nobody listens to says so") {
  opal::NullEventSink sink;
  CHECK_FALSE(sink.listening());
}
