#include "viewer/serving/record_log.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

using Kind = RecordLog::Kind;
constexpr std::chrono::milliseconds kNow{0};

/// Two first records, then one a second; every tenth is one that a reader can begin with.
void write_hour(RecordLog& log, int seconds = 3600) {
  log.append("run", Kind::first);
  log.append("map", Kind::first);
  for (int s = 0; s < seconds; ++s) log.append(std::to_string(s), s % 10 == 0 ? Kind::begins : Kind::follows, s);
}

/// What a reader gets that begins at a position and goes on to the end.
std::vector<std::string> read_from(const RecordLog& log, std::size_t position) {
  std::vector<std::string> records;
  while (position < log.size()) {
    const RecordLog::Reading reading = log.wait(position, {}, kNow);
    records.push_back(*reading.record);
    position = reading.position + 1;
  }
  return records;
}

}  // namespace

TEST_CASE("a log without a window keeps every record") {
  RecordLog log;
  write_hour(log);
  CHECK(log.size() == 3602);
  CHECK(read_from(log, 0).size() == 3602);
}

TEST_CASE("a log with a window keeps the first records and at least the newest window") {
  RecordLog log({.seconds = 60});
  write_hour(log);
  CHECK(log.size() == 3602);
  const std::vector<std::string> records = read_from(log, 0);
  CHECK(records.front() == "run");
  CHECK(records[1] == "map");
  CHECK(records[2] == "3530");
  CHECK(records.back() == "3599");
  CHECK(records.size() == 2 + 70);
}

TEST_CASE("a window may be full by bytes before it is by time") {
  RecordLog log({.seconds = 600, .bytes = 100});
  write_hour(log);
  CHECK(log.bytes() < 6 + 100 + 2 * 40);
  CHECK(read_from(log, 0)[2] == "3560");
}

TEST_CASE("a reader who falls behind the window is given the run anew") {
  RecordLog log({.seconds = 60});
  write_hour(log, 200);
  const RecordLog::Reading reading = log.wait(50, {}, kNow);
  CHECK(reading.position == 0);
  CHECK(*reading.record == "run");
  CHECK(read_from(log, 50) == read_from(log, 0));
  CHECK(read_from(log, 190).front() == "188");
}

TEST_CASE("a record that is being read stays, though the log drops it") {
  RecordLog log({.seconds = 60});
  write_hour(log, 10);
  const RecordLog::Reading reading = log.wait(5, {}, kNow);
  for (int s = 10; s < 200; ++s) log.append("later", s % 10 == 0 ? Kind::begins : Kind::follows, s);
  CHECK(*reading.record == "3");
}
