// A robot with two lasers that scan ten times a second, the rear one 40 ms after the front one.
#include <opal/sensing/scan_pairing.hpp>

#include <catch2/catch.hpp>

#include <algorithm>

namespace {

using namespace opal;

constexpr double kPeriod_s = 0.1, kRearLater_s = 0.04;

LaserModel laser_at(const std::string& frame, const Pose2& T_base_laser) {
  LaserModel laser;
  laser.frame = frame;
  laser.T_base_laser = T_base_laser;
  return laser;
}

std::vector<LaserModel> two_lasers() {
  return {laser_at("front", Pose2(0.3, 0, 0)), laser_at("rear", Pose2(-0.3, 0, 3.1))};
}

RawScan scan_of(const std::string& frame, double stamp_s) {
  RawScan raw;
  raw.stamp_s = stamp_s;
  raw.frame = frame;
  raw.ranges_m.assign(361, 2);
  return raw;
}

Pose2 where(double stamp_s) { return {0.5 * stamp_s, 0, 0.8 * stamp_s}; }

Pose2 turning(double stamp_s) { return {0, 0, 0.8 * stamp_s}; }
Pose2 straight_on(double stamp_s) { return {0.5 * stamp_s, 0, 0}; }

/// What the robot says over some seconds, in the order of stamps. @param at  where it is when.
std::vector<LogRecord> said(double duration_s, Pose2 (*at)(double) = where) {
  std::vector<LogRecord> records;
  for (int k = 0; k * kPeriod_s < duration_s; ++k) {
    const double front_s = k * kPeriod_s;
    for (const double at_s : {front_s - 0.03, front_s + 0.02}) records.emplace_back(OdometryRecord{at_s, at(at_s)});
    records.insert(records.end() - 1, scan_of("front", front_s));
    records.emplace_back(scan_of("rear", front_s + kRearLater_s));
  }
  records.emplace_back(OdometryRecord{duration_s + 1, at(duration_s + 1)});
  return records;
}

std::vector<Sample> paired(const std::vector<LogRecord>& records, ScanPairing pairing = ScanPairing(two_lasers())) {
  std::vector<Sample> samples;
  const auto take_all = [&] {
    while (auto sample = pairing.next()) samples.push_back(std::move(*sample));
  };
  for (const LogRecord& record : records) {
    pairing.take(record);
    take_all();
  }
  pairing.finish();
  take_all();
  return samples;
}

std::vector<LogRecord> without(std::vector<LogRecord> records, const std::string& frame, double from_s, double to_s) {
  std::erase_if(records, [&](const LogRecord& record) {
    const auto* scan = std::get_if<RawScan>(&record);
    return scan && scan->frame == frame && scan->stamp_s >= from_s && scan->stamp_s < to_s;
  });
  return records;
}

std::size_t with_both(const std::vector<Sample>& samples) {
  return static_cast<std::size_t>(
      std::count_if(samples.begin(), samples.end(), [](const Sample& sample) { return sample.views.size() == 2; }));
}

}  // namespace

TEST_CASE("scans of two lasers that begin at about one time are one sample") {
  const std::vector<Sample> samples = paired(said(3));
  CHECK(samples.size() <= 31);
  CHECK(with_both(samples) >= 29);
  for (const Sample& sample : samples) {
    CHECK(sample.stamp_s == sample.views.back().scan.stamp_s);
    CHECK(distance_m(sample.T_odom_base, where(sample.stamp_s)) < 1e-3);
  }
}

TEST_CASE(
    "each view keeps where its laser was when it scanned, also while the robot only turns, or drives straight on") {
  const auto at = GENERATE(where, turning, straight_on);
  for (const Sample& sample : paired(said(1, at)))
    for (const LaserView& view : sample.views) {
      const Pose2 T_odom_laser =
          at(view.scan.stamp_s) * two_lasers()[static_cast<std::size_t>(view.laser)].T_base_laser;
      CHECK(distance_m(sample.T_odom_base * view.T_base_laser, T_odom_laser) < 2e-3);
      CHECK(angle_between_rad(sample.T_odom_base * view.T_base_laser, T_odom_laser) < 2e-3);
    }
}

TEST_CASE("where one laser falls silent, the other goes on, and both are one sample again when it comes back") {
  const std::vector<Sample> samples = paired(without(said(6), "rear", 2, 4));
  CHECK(samples.size() >= 58);
  const auto in_gap = [](const Sample& sample) { return sample.stamp_s > 2 && sample.stamp_s < 4; };
  CHECK(std::count_if(samples.begin(), samples.end(), in_gap) >= 19);
  const std::vector<Sample> after(samples.end() - 15, samples.end());
  CHECK(with_both(after) >= 14);
}

TEST_CASE("a sample is not held back for a laser that is silent") {
  ScanPairing pairing(two_lasers());
  double waited_s = 0, newest_s = 0;
  for (const LogRecord& record : without(said(6), "rear", 2, 6)) {
    pairing.take(record);
    if (const auto* scan = std::get_if<RawScan>(&record)) newest_s = std::max(newest_s, scan->stamp_s);
    while (const auto sample = pairing.next())
      if (sample->stamp_s > 3) waited_s = std::max(waited_s, newest_s - sample->stamp_s);
  }
  CHECK(waited_s < 1.5 * kPeriod_s);
}

TEST_CASE("stamps of samples never step back, whatever the order of arrival") {
  std::vector<LogRecord> records = said(4);
  for (std::size_t k = 0; k + 3 < records.size(); k += 5) std::swap(records[k], records[k + 2]);
  double before_s = -1;
  for (const Sample& sample : paired(records)) {
    CHECK(sample.stamp_s > before_s);
    before_s = sample.stamp_s;
  }
}

TEST_CASE("a scan of a laser that nobody described is left out and counted") {
  ScanPairing pairing(two_lasers());
  pairing.take(OdometryRecord{0, Pose2()});
  pairing.take(scan_of("elsewhere", 0.1));
  pairing.take(OdometryRecord{1, Pose2()});
  CHECK_FALSE(pairing.next());
  CHECK(pairing.counts().at("scan of a laser that is not described") == 1);
}

TEST_CASE("a laser at another rate is in as many samples as it has scans") {
  std::vector<LogRecord> records;
  for (int k = 0; k < 200; ++k) {
    const double at_s = 0.025 * k;
    records.emplace_back(scan_of("front", at_s));
    if (k % 4 == 0) records.emplace_back(scan_of("rear", at_s + 0.005));
    records.emplace_back(OdometryRecord{at_s + 0.01, where(at_s + 0.01)});
  }
  const std::vector<Sample> samples = paired(records);
  CHECK(samples.size() >= 195);
  CHECK(samples.size() <= 202);
  CHECK(with_both(samples) >= 45);
}
