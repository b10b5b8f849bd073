#include "tests/kit/temporary_folder.hpp"
#include "tests/viewer/synthetic_run.hpp"

#include "viewer/words/moment.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <fstream>

using namespace opal;
using Catch::Matchers::Contains;

namespace {

/// A run of three time lines, q0 to q2, whose updates are 0.25 s apart; q0 begins at stamp 1000, q1 at 11000.
class WrittenRun {
 public:
  WrittenRun() {
    std::ofstream file(path());
    JsonLinesSink events(file);
    synthetic::write_run({.updates = 60, .hypotheses = 5, .time_lines = 3}, events);
  }
  std::string path() const { return folder_.path_of("run.jsonl"); }

 private:
  TemporaryFolder folder_;
};

/// The newest frame at a moment, as "TIME_LINE KEYFRAME".
std::string newest(const WrittenRun& run, const std::string& at, const std::string& query = "") {
  std::string time_line, found;
  read_until(run.path(), parse_moment(at, query), [&](const RunHeader&, const RunFrame& frame) {
    time_line = frame.starts.value_or(time_line);
    found = time_line + " " + to_string(frame.keyframe);
  });
  return found;
}

}  // namespace

TEST_CASE("a moment is the newest update that is not after it") {
  const WrittenRun run;
  CHECK(newest(run, "0") == "q0 0");
  CHECK(newest(run, "0.25") == "q0 1");
  CHECK(newest(run, "0.49") == "q0 1");
  CHECK(newest(run, "stamp:1001.5") == "q0 6");
  CHECK(newest(run, "4.75") == "q0 19");
}

TEST_CASE("a moment is looked for in the time line that is named, in the first one otherwise") {
  const WrittenRun run;
  CHECK(newest(run, "1", "q1") == "q1 4");
  CHECK(newest(run, "stamp:11001", "q1") == "q1 4");
  CHECK(newest(run, "end", "q1") == "q1 19");
  CHECK(newest(run, "end") == "q2 19");
}

TEST_CASE("a moment that is none, or is not in the run, is an error that says what there is") {
  const WrittenRun run;
  for (const char* text : {"", "soon", "1.5s", "nan", "inf", "stamp:", "stamp:x", "1 2", "0x10"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH(parse_moment(text, ""), Contains("'" + std::string(text) + "'") && Contains("expected seconds"));
  }
  CHECK_THROWS_WITH(newest(run, "1", "q7"), Contains("'q7'") && Contains("q0, q1, q2"));
  CHECK_THROWS_WITH(newest(run, "-1"), Contains("moment -1.000 s, expected one from 0.000 s on"));
  CHECK_THROWS_WITH(newest(run, "4.76"), Contains("moment 4.760 s, expected one in [0.000, 4.750]"));
  CHECK_THROWS_WITH(newest(run, "stamp:21004.76", "q2"), Contains("in [21000.000, 21004.750]"));
  CHECK_THROWS_AS(newest(run, "stamp:10", "q1"), EventError);
}

TEST_CASE("a run that ended before its first update is an error that says so") {
  const WrittenRun run;
  std::ifstream whole(run.path());
  std::string line, two;
  for (int k = 0; k < 2 && std::getline(whole, line); ++k) two += line + '\n';
  whole.close();
  std::ofstream(run.path()) << two;
  CHECK_THROWS_WITH(newest(run, "end"), Contains("no complete update"));
}
