// Scans that bring their own odometry along, and take no time.
#include <opal/sensing/scan_pairing.hpp>

#include <catch2/catch.hpp>

namespace {

using namespace opal;

/// Of a robot that turns and drives evenly.
Pose2 on_its_way(double time_s) { return {0.8 * time_s, 0.1 * time_s, 1.2 * time_s}; }
OdometryRecord record_at(double stamp_s) { return {stamp_s, on_its_way(stamp_s)}; }

RawScan full_scan(double stamp_s, float range_m) {
  RawScan raw;
  raw.stamp_s = stamp_s;
  raw.ranges_m.assign(361, range_m);
  return raw;
}

}  // namespace

TEST_CASE("odometry that a scan of no duration brings along makes no record late that comes after it") {
  ScanPairing pairing({LaserModel{}});
  pairing.take(record_at(1.0));
  RawScan raw = full_scan(1.05, 2);
  raw.T_odom_base = on_its_way(raw.stamp_s);
  pairing.take(raw);
  pairing.take(record_at(1.04));
  CHECK(pairing.next());
  CHECK(pairing.counts().empty());
}

TEST_CASE("a scan without odometry is placed by the records, whatever a scan of no duration brings along") {
  ScanPairing pairing({LaserModel{}});
  pairing.take(record_at(1.0));
  RawScan raw = full_scan(1.1, 2);
  raw.T_odom_base = on_its_way(raw.stamp_s) * Pose2(0.05, 0.05, 0);
  pairing.take(raw);
  pairing.take(full_scan(1.15, 3));
  pairing.take(record_at(1.2));
  REQUIRE(pairing.next());
  const auto sample = pairing.next();
  REQUIRE(sample);
  CHECK(distance_m(sample->T_odom_base, on_its_way(1.15)) < 1e-3);
}
