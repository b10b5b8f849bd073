// The time that a simulation or a replayed recording tells.
#include "recording/ros_messages.hpp"
#include "tests/plugins/logs/bag_writer.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>

using namespace opal::recording;

namespace {

std::optional<double> decoded(std::int32_t seconds, std::uint32_t nanoseconds, std::size_t bytes_lost = 0) {
  opal::log_tests::CdrWriter cdr;
  cdr.number(seconds);
  cdr.number(nanoseconds);
  const std::string bytes = cdr.bytes();
  return decode_clock(std::as_bytes(std::span(bytes)).first(bytes.size() - bytes_lost), Wire::cdr);
}

}  // namespace

TEST_CASE("a clock tells seconds and nanoseconds, and one that is damaged tells no time") {
  CHECK(decoded(12, 250'000'000).value() == Approx(12.25));
  CHECK(decoded(0, 999'999'999).value() == Approx(1));
  CHECK_FALSE(decoded(12, 1'000'000'000).has_value());
  CHECK_FALSE(decoded(12, 0, 1).has_value());
}
