#include "viewer/reading/run_reader.hpp"
#include "recorded_run.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::synthetic;
using Catch::Contains;

namespace {

const std::string kHead =
    R"({"event":"run","format":3,"opal":"0.1.0"})"
    "\n"
    R"({"event":"map","name":"m","objects":[["w","opal:Wall"]],"features":[{"id":"w/face","object":0,"type":"opal:Wall","segment":[0,0,5,0]}],"patterns":[]})"
    "\n";

/// One update that starts here.
std::string update(int keyframe, double stamp_s, const std::string& between = "") {
  const std::string common = R"("stamp_s":)" + std::to_string(stamp_s) + R"(,"keyframe":)" + std::to_string(keyframe);
  return R"({"event":"keyframe",)" + common +
         R"(,"T_local_base":[1,2,0.5]})"
         "\n" +
         between + R"({"event":"estimate",)" + common +
         R"(,"status":"searching","probability":0,"hypotheses":[]})"
         "\n"
         R"({"event":"cost",)" +
         common +
         R"(,"cpu_ms":{"total":1.5,"detect":0.5}})"
         "\n";
}

std::string events_at(int keyframe, const std::string& rest) {
  return R"({"keyframe":)" + std::to_string(keyframe) + R"(,"stamp_s":1,)" + rest + "}\n";
}

ReadRun read_text(const std::string& text, std::vector<std::string>* notes = nullptr) {
  const EventFile file(text);
  ReadRun run;
  const RunReading reading = read_run(file.path(), [&](const RunHeader&, RunFrame&& frame) {
    run.frames.push_back(std::move(frame));
    return true;
  });
  run.header = reading.header;
  if (notes) *notes = reading.notes;
  return run;
}

void expect_error(const std::string& text, int line, const std::string& words) {
  INFO(text);
  CHECK_THROWS_WITH(read_text(text), Contains(".jsonl:" + std::to_string(line) + ": ") && Contains(words));
  CHECK_THROWS_AS(read_text(text), EventError);
}

}  // namespace

TEST_CASE("frames say what the events say") {
  const auto events = lines_of(text_of({20, 6, 12}));
  const ReadRun run = frames_of({20, 6, 12});
  REQUIRE(run.frames.size() == 20);
  CHECK(run.header->features.size() == 16);
  CHECK(run.header->patterns.at(0).features.size() == 12);
  std::size_t frame = 0, spawned = 0;
  for (const std::string& line : events) {
    const Event event = Event::parse(line);
    if (event["event"] == "spawned") {
      const RecordedSpawn& spawn = run.frames[frame].spawns.at(spawned++);
      CHECK(spawn.id == event["hypothesis"].get<HypothesisId>());
      CHECK(spawn.parent == HypothesisId(event.value("parent", -1)));
      CHECK(spawn.T_map_base.x() == event["T_map_base"][0]);
      const Event& mapped = event["pairs"][0][1];
      CHECK((mapped.is_null() ? !spawn.pairs[0].map_feature.exists()
                              : run.header->feature(spawn.pairs[0].map_feature).id == mapped.get<std::string>()));
    }
    if (event["event"] == "estimate") {
      const RunFrame& read = run.frames[frame];
      CHECK(read.stamp_s == event["stamp_s"]);
      CHECK(read.time_s == Approx(read.stamp_s - 1000));
      CHECK(read.status == event["status"].get<std::string>());
      CHECK(read.best == event["hypothesis"].get<HypothesisId>());
      REQUIRE(read.hypotheses.size() == event["hypotheses"].size());
      CHECK(read.hypotheses[3].log_likelihood == event["hypotheses"][3]["log_likelihood"]);
      CHECK(read.hypotheses[3].scores.size() == 3);
      CHECK(read.findings.at(0).line.size() == 2);
      CHECK(read.scan.size() == 12);
      CHECK(read.cpu_ms.back().first == "total");
      REQUIRE(spawned == read.spawns.size());
      spawned = 0;
      ++frame;
    }
  }
}

TEST_CASE("a place says what it comes from: its template, or else what the event says") {
  const auto spawned = [](int id, const std::string& from) {
    return events_at(0, R"("event":"spawned","hypothesis":)" + std::to_string(id) +
                            R"(,"T_map_base":[1,2,0],"log_likelihood":0,"pairs":[],)" + from);
  };
  const ReadRun run = read_text(
      kHead + update(0, 1,
                     spawned(0, R"("origin":"pattern","template":"opal:Row")") + spawned(1, R"("origin":"hint")") +
                         spawned(2, R"("origin":"other_storey")") + spawned(3, R"("origin":"branch","parent":0)")));
  const std::vector<RecordedSpawn>& spawns = run.frames.at(0).spawns;
  REQUIRE(spawns.size() == 4);
  CHECK(spawns[0].origin == "opal:Row");
  CHECK(spawns[1].origin == "a hint");
  CHECK(spawns[2].origin == "another storey");
  CHECK(spawns[3].origin.empty());
}

TEST_CASE("truth is interpolated between what was recorded, and absent outside") {
  const std::string truth = R"({"event":"truth","poses":[[10,0,0,3.1],[12,2,4,-3.1]]})"
                            "\n";
  const ReadRun run = read_text(kHead +
                                R"({"event":"start","query":"q"})"
                                "\n" +
                                truth + update(0, 9) + update(1, 11) + update(2, 12.5));
  CHECK(run.frames[0].starts == "q");
  CHECK_FALSE(run.frames[0].truth);
  REQUIRE(run.frames[1].truth);
  CHECK(run.frames[1].truth->x() == Approx(1));
  CHECK(run.frames[1].truth->y() == Approx(2));
  CHECK(std::abs(run.frames[1].truth->heading_rad()) == Approx(std::numbers::pi));
  CHECK_FALSE(run.frames[2].truth);
  CHECK(run.frames[2].time_s == Approx(3.5));
}

TEST_CASE("a new time line starts anew: time, truth, stamps") {
  const ReadRun run = frames_of({30, 5, 8, 3});
  REQUIRE(run.frames.size() == 30);
  for (std::size_t k = 0; k < 30; ++k) {
    CHECK(run.frames[k].starts.has_value() == (k % 10 == 0));
    CHECK(run.frames[k].time_s == Approx(0.25 * double(k % 10)));
  }
  CHECK(run.frames[20].starts == "q2");
}

TEST_CASE("a stream that is cut anywhere is read up to there, with a note, or is an error that names the line") {
  const std::string text = text_of({3, 3, 4});
  const EventFile file(text);
  std::size_t frames = 3;
  for (std::size_t bytes = text.size(); bytes < text.size() + 1; --bytes) {  // to 0
    file.cut_to(bytes);
    std::size_t read = 0;
    try {
      const RunReading reading = read_run(file.path(), [&](const RunHeader&, RunFrame&&) { return ++read > 0; });
      CHECK(read <= frames);
      frames = read;
      const bool mid_line = bytes < text.size() && text[bytes - 1] != '\n' && text[bytes] != '\n';
      if (mid_line) CHECK(reading.notes.size() >= 1);
      if (text.substr(0, bytes).ends_with("}}\n") && read > 0) CHECK(reading.notes.empty());
    } catch (const EventError& error) {
      CHECK(read == 0);
      frames = 0;
      CHECK_THAT(error.what(), Contains(".jsonl:"));
      CHECK_THAT(error.what(), Contains("expected"));
    }
  }
  CHECK(frames == 0);
}

TEST_CASE("a broken line in the middle is an error, at the end of the stream a note") {
  std::vector<std::string> notes;
  const ReadRun run = read_text(kHead + update(0, 1) + R"({"event":"keyframe","stamp)", &notes);
  CHECK(run.frames.size() == 1);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Contains("line 6 is cut off"));
  expect_error(kHead +
                   R"({"event":"keyframe","stamp)"
                   "\n" +
                   update(0, 1),
               3, "expected JSON text");
  read_text(kHead + update(0, 1) +
                R"({"event":"keyframe","stamp_s":2,"keyframe":1,"T_local_base":[0,0,0]})"
                "\n",
            &notes);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Contains("within keyframe 1"));
}

TEST_CASE("streams of other formats, and what is none, are refused with the reason") {
  expect_error(update(0, 1), 1, "older version of Opal");
  expect_error(R"({"event":"run","format":4})"
               "\n",
               1, "/format: 4, expected 3");
  expect_error(R"({"event":"run","format":1})"
               "\n",
               1, "/format: 1, expected 3");
  expect_error(R"({"event":"run"})"
               "\n",
               1, "a member 'format'");
  expect_error("", 0, "'map' event");
  expect_error("hello\n", 1, "expected JSON text");
  expect_error("[1]\n", 1, "expected an object");
  expect_error("{}\n", 1, "'event'");
  expect_error(kHead.substr(0, kHead.find('\n') + 1) + update(0, 1), 2, "'map' before the first keyframe");
  expect_error(kHead + kHead.substr(kHead.find('\n') + 1), 3, "one 'map' per stream");
  expect_error(kHead + kHead, 3, "one 'run' per stream");
  CHECK_THROWS_WITH(event_file("/nonexistent/run"), Contains("/nonexistent/run: does not exist"));
  CHECK_THROWS_WITH(event_file("/tmp"), Contains("events.jsonl: does not exist"));
}

TEST_CASE("what newer versions add is passed over") {
  const std::string unknown = R"({"event":"dreamt","keyframe":0,"of":{"electric":"sheep"}})"
                              "\n";
  const ReadRun run = read_text(kHead + unknown + update(0, 1, unknown) + unknown + update(1, 2));
  CHECK(run.frames.size() == 2);
}

TEST_CASE("events out of order are errors") {
  const std::string start = R"({"event":"start","query":"q"})"
                            "\n";
  expect_error(kHead + update(0, 1, start), 4, "'cost' of keyframe 0 first");
  expect_error(kHead + update(0, 1, events_at(0, R"("event":"cost","cpu_ms":{"total":1})")), 4, "'estimate' before it");
  expect_error(kHead + update(0, 1, events_at(1, R"("event":"associated","hypothesis":1,"pairs":[])")), 4,
               "the open keyframe");
  expect_error(kHead + events_at(0, R"("event":"associated","hypothesis":1,"pairs":[])"), 3, "that begins this update");
}

TEST_CASE("time goes on where the clock is set back") {
  const ReadRun run = read_text(kHead + update(0, 20) + update(1, 22) + update(2, 12) + update(3, 15));
  REQUIRE(run.frames.size() == 4);
  CHECK(run.frames[1].time_s == 2);
  CHECK(run.frames[2].time_s == 2);
  CHECK(run.frames[2].stamp_s == 12);
  CHECK(run.frames[3].time_s == 5);
}

TEST_CASE("values that cannot be are errors that name the place") {
  const auto refused = [](const std::string& rest, const std::string& words) {
    expect_error(kHead + update(0, 1, events_at(0, rest)), 4, words);
  };
  refused(R"("event":"spawned","hypothesis":1,"T_map_base":[1e308,0,0],"log_likelihood":0,"pairs":[])",
          "spawned: /T_map_base/0: 1e+308, expected a number in [-1e+06, 1e+06]");
  refused(R"("event":"spawned","hypothesis":1,"T_map_base":[1e999,0,0],"pairs":[])", "a finite number");
  refused(R"("event":"spawned","hypothesis":1,"T_map_base":[0,0],"pairs":[])", "expected [x, y, heading]");
  refused(R"("event":"spawned","hypothesis":1.5,"T_map_base":[0,0,0],"pairs":[])",
          "/hypothesis: 1.5, expected an integer");
  refused(R"("event":"spawned","hypothesis":99999999999,"T_map_base":[0,0,0],"pairs":[])", "expected an integer");
  refused(R"("event":"spawned","hypothesis":1,"T_map_base":[0,0,0],"pairs":[[1,"<script>"]])",
          "/pairs/0/1: \"<script>\", expected the id of a feature");
  refused(R"("event":"local_features","changed":[{"id":1,"type":"t","stable":true,"measurements":2}])", "'segment'");
  refused(R"("event":"local_features","changed":[{"id":1,"type":"t","stable":1,"measurements":2,"point":[0,0]}])",
          "/changed/0/stable: 1, expected true or false");
  refused(R"("event":"estimate","status":"happy","probability":1,"hypotheses":[])", "/status: \"happy\"");
  refused(R"("event":"estimate","status":"lost","probability":1.5,"hypotheses":[])", "a number in [0, 1]");
  const std::string row = R"({"hypothesis":7,"T_map_base":[0,0,0],"log_likelihood":0,"probability":0})";
  refused(R"("event":"estimate","status":"lost","probability":1,"hypotheses":[)" + row + "," + row + "]",
          "each hypothesis once");
  refused(R"("event":"spawned","event":"spawned")", "stands twice");
  refused(R"("event":"pruned","hypothesis":1,"reason":)" + std::string(100, '[') + std::string(100, ']'), "nested");
  expect_error(kHead + R"({"event":"truth","poses":[[2,0,0,0],[2,0,0,0]]})"
                       "\n",
               3, "/poses/1/0: 2");
  const std::string map = R"({"event":"map","objects":[["a","t"],["a","t"]],"features":[]})";
  expect_error(kHead.substr(0, kHead.find('\n') + 1) + map + "\n", 2, "/objects/1/0: \"a\", expected an id");
}

TEST_CASE("whatever one value is replaced with, frames come out or an EventError") {
  const auto lines = lines_of(text_of({2, 3, 4}));
  const Event replacements[] = {
      nullptr, true, "x", -5, 3.5, 1e308, 99999999999LL, Event::array(), Event::object(), Event::array({1, 2, 3})};
  std::vector<Event> events;
  for (const std::string& line : lines) events.push_back(Event::parse(line));
  int errors = 0, good = 0;
  const auto feed = [&](std::size_t changed, const Event& event) {
    FrameBuilder builder;
    try {
      for (std::size_t k = 0; k < events.size(); ++k) builder.add(k == changed ? event : events[k]);
      ++good;
    } catch (const EventError& error) {
      CHECK_THAT(error.what(), Contains(", expected "));
      ++errors;
    }
  };
  for (std::size_t k = 0; k < events.size(); ++k) {
    const Event places = events[k].flatten();
    for (const auto& [pointer, value] : places.items())
      for (const Event& replacement : replacements) {
        Event event = events[k];
        event[Event::json_pointer(pointer)] = replacement;
        feed(k, event);
      }
  }
  CHECK(errors > 1000);
  CHECK(good > 100);
}

TEST_CASE("very long words are cut, very long names refused") {
  const std::string reason(100'000, 'x'), name(5000, 'n');
  const ReadRun run = read_text(
      kHead + update(0, 1, events_at(0, R"("event":"rejected","hypothesis":1,"pairs":[],"reason":")" + reason + '"')));
  CHECK(run.frames[0].rejections.at(0).reason.size() < 5000);
  expect_error(kHead + R"({"event":"start","query":")" + name + "\"}\n", 3, "at most 1000 bytes");
}
