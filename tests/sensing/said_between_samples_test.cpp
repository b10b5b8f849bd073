// What somebody says goes with the sample after it.
#include <opal/sensing/replay.hpp>
#include <opal/sensing/scan_pairing.hpp>

#include <catch2/catch.hpp>

namespace {

using namespace opal;

RawScan distinct_scan(double stamp_s) {
  RawScan raw;
  raw.stamp_s = stamp_s;
  raw.ranges_m.assign(361, static_cast<float>(stamp_s));
  return raw;
}

HintRecord hint_at(double stamp_s) { return {stamp_s, {Pose2(stamp_s, 0, 0), 0.2, 0.1}}; }

/// A robot that stands, with a scan each second, and somebody who talks between.
std::vector<LogRecord> drive_with(double begin_s, double end_s, const std::vector<std::pair<double, LogRecord>>& said) {
  std::vector<LogRecord> records;
  for (double s = begin_s; s <= end_s; ++s) {
    records.push_back(OdometryRecord{s, Pose2()});
    records.push_back(distinct_scan(s));
    for (const auto& [at_s, record] : said)
      if (at_s > s && at_s < s + 1) records.push_back(record);
  }
  return records;
}

std::vector<Sample> samples_of(const std::vector<LogRecord>& records, const ReplayOptions& options = {}) {
  Replay replay(records, {LaserModel{}}, options);
  return read_all(replay);
}

}  // namespace

TEST_CASE("a hint goes with the next sample, and with no other") {
  const auto samples = samples_of(drive_with(1, 5, {{2.5, hint_at(2.5)}}));
  REQUIRE(samples.size() == 5);
  for (const Sample& sample : samples) {
    CHECK(sample.said.hint.has_value() == (sample.stamp_s == 3));
    CHECK_FALSE(sample.said.forget);
  }
  CHECK(samples[2].said.hint->T_map_base.x() == 2.5);
}

TEST_CASE("who says to forget means what was said before, too") {
  const auto hint_first = samples_of(drive_with(1, 3, {{1.2, hint_at(1.2)}, {1.7, ForgetRecord{}}}));
  CHECK(hint_first[1].said.forget);
  CHECK_FALSE(hint_first[1].said.hint);
  const auto hint_last = samples_of(drive_with(1, 3, {{1.2, ForgetRecord{}}, {1.7, hint_at(1.7)}}));
  CHECK(hint_last[1].said.forget);
  CHECK(hint_last[1].said.hint->T_map_base.x() == 1.7);
  CHECK_FALSE(hint_last[2].said.forget);
}

TEST_CASE("of two hints the newer one holds") {
  const auto samples = samples_of(drive_with(1, 3, {{1.2, hint_at(1.2)}, {1.7, hint_at(1.7)}}));
  CHECK(samples[1].said.hint->T_map_base.x() == 1.7);
}

TEST_CASE("a replay of a part has the hints of that part only") {
  ReplayOptions part;
  part.from_s = 3;
  part.to_s = 5;
  const auto samples =
      samples_of(drive_with(1, 8, {{1.5, hint_at(1.5)}, {3.5, hint_at(3.5)}, {6.5, hint_at(6.5)}}), part);
  REQUIRE(samples.size() == 3);
  CHECK_FALSE(samples[0].said.hint);
  CHECK(samples[1].said.hint->T_map_base.x() == 3.5);
  CHECK_FALSE(samples[2].said.hint);
}
