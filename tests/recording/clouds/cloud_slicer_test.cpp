#include "recording/cloud_slicer.hpp"
#include "cloud_message.hpp"

#include <catch2/catch.hpp>

#include <span>

using namespace opal;
using namespace opal::recording;
using namespace opal::recording_tests;

namespace {

/// Four beams: forward, left, back, right; heights from 0.5 to 1.5 m.
LaserModel four_beams() {
  LaserModel laser;
  laser.beams = 4;
  laser.angle_min_rad = 0;
  laser.angle_increment_rad = std::numbers::pi / 2;
  laser.range_min_m = 0.2;
  laser.range_max_m = 20;
  laser.slice = CloudSlice{0.5, 1.5, 1, 0, 0};
  return laser;
}

RawScan sliced(const CloudSlicer& slicer, const CloudMessage& made) {
  const std::string message = made.bytes();
  const DecodedPointCloud decoded = decode_point_cloud(std::as_bytes(std::span(message)), Wire::cdr);
  REQUIRE(decoded.cloud);
  return slicer.scan_of(*decoded.cloud);
}

RawScan sliced(const LaserModel& laser, const std::vector<MadePoint>& points) {
  CloudMessage made;
  made.number_type = kFloat64;
  made.points = points;
  return sliced(CloudSlicer(laser), made);
}

}  // namespace

TEST_CASE("the nearest point between the heights is the range of a beam, and a beam without a point is unknown") {
  const RawScan scan = sliced(four_beams(), {{5, 0, 0}, {4, 0, 0.4}, {3, 0, 0.6}, {2, 0, -0.6}, {0, 6, 0.1}});
  REQUIRE(scan.ranges_m.size() == 4);
  CHECK(scan.ranges_m[0] == 4.0f);  // nearer ones are too high and too low
  CHECK(scan.ranges_m[1] == 6.0f);
  CHECK(std::isnan(scan.ranges_m[2]));
  CHECK(std::isnan(scan.ranges_m[3]));
  CHECK(scan.frame == "lidar");
  const Scan clean = make_scan(scan, four_beams());
  CHECK(clean.points.size() == 2);
  CHECK(clean.free_bearings_rad.empty());
  CHECK(clean.invalid == 2);
}

TEST_CASE("a beam is free only if its nearest point lies beyond the range of the laser") {
  const Scan clean = make_scan(sliced(four_beams(), {{30, 0, 0}, {0, 30, 0}, {0, 10, 0}}), four_beams());
  CHECK(clean.free_bearings_rad == std::vector<double>{0});
  CHECK(clean.points.size() == 1);
}

TEST_CASE("points of the robot itself hide nothing") {
  CHECK(sliced(four_beams(), {{0.1, 0, 0}, {5, 0, 0}}).ranges_m[0] == 5.0f);
}

TEST_CASE("each beam has the points that lie nearest to it, and the last one does not overlap the first") {
  const RawScan scan = sliced(four_beams(), {{5, -4.9, 0}, {-4.9, 5, 0}, {-4.9, -5, 0}});
  CHECK(scan.ranges_m[0] == Approx(std::hypot(5, 4.9)));
  CHECK(scan.ranges_m[1] == Approx(std::hypot(5, 4.9)));
  CHECK(std::isnan(scan.ranges_m[2]));
  CHECK(scan.ranges_m[3] == Approx(std::hypot(5, 4.9)));
}

TEST_CASE("points outside the field of view are left out") {
  LaserModel half = four_beams();
  half.beams = 2;
  const RawScan scan = sliced(half, {{-5, 0, 0}, {0, -5, 0}, {0, 3, 0}});
  REQUIRE(scan.ranges_m.size() == 2);
  CHECK(std::isnan(scan.ranges_m[0]));
  CHECK(scan.ranges_m[1] == 3.0f);
}

TEST_CASE("heights are those above the floor, however the sensor is mounted") {
  const double roll = GENERATE(0.0, 0.3, std::numbers::pi);
  const double pitch = GENERATE(0.0, -0.4, 0.5);
  const bool by_log = GENERATE(false, true);
  LaserModel laser = four_beams();
  laser.T_base_laser = Pose2(0.2, -0.1, 0.7);
  laser.slice = CloudSlice{0.5, 1.5, 1.2, roll, pitch};
  const Eigen::Isometry3d T_base_sensor = described_mount(laser);
  laser.geometry_from_log = by_log;
  if (by_log) laser.slice->height_m = laser.slice->roll_rad = 99;  // the log knows better
  CloudSlicer slicer(laser);
  slicer.set_mount(T_base_sensor);
  CloudMessage made;
  made.number_type = kFloat64;
  const Pose2 T_base_laser = projected(T_base_sensor);
  for (const auto& [range_m, height_m] : {std::pair(4.0, 0.6), std::pair(3.0, 0.4), std::pair(2.0, 1.6)}) {
    const Point on_floor = T_base_laser * Point(range_m, 0);
    const Eigen::Vector3d seen = T_base_sensor.inverse() * Eigen::Vector3d(on_floor.x(), on_floor.y(), height_m);
    made.points.push_back({seen.x(), seen.y(), seen.z()});
  }
  CHECK(sliced(slicer, made).ranges_m[0] == Approx(4));
}

TEST_CASE("where points have times, the scan begins with its first point and each beam has its own time") {
  CloudMessage made;
  made.stamp_s = 10;
  made.time_name = "time";
  made.time_type = kFloat32;
  made.points = {{1, 0, 0, -0.05}, {0, 2, 0, -0.03}, {0, -3, 0, 0}, {0, 4, 50, -0.09}};  // the last one is too high
  const RawScan scan = sliced(CloudSlicer(four_beams()), made);
  CHECK(scan.stamp_s == Approx(9.95));
  REQUIRE(scan.beam_times_s.size() == 4);
  CHECK(scan.beam_times_s[0] == Approx(0));
  CHECK(scan.beam_times_s[1] == Approx(0.02));
  CHECK(scan.beam_times_s[2] == 0);
  CHECK(scan.beam_times_s[3] == Approx(0.05));
}

TEST_CASE("a point whose time is no number counts as measured at the stamp of the scan") {
  CloudMessage made;
  made.time_name = "time";
  made.time_type = kFloat32;
  made.points = {{1, 0, 0, 0.01}, {0, 2, 0, std::nan("")}, {0, -3, 0, 0.05}};
  const RawScan scan = sliced(CloudSlicer(four_beams()), made);
  REQUIRE(scan.beam_times_s.size() == 4);
  CHECK(scan.beam_times_s[1] == 0);
  CHECK(scan.beam_times_s[3] == Approx(0.04));
}

TEST_CASE("an empty cloud is a scan without a valid beam") {
  const RawScan scan = sliced(four_beams(), {});
  CHECK(scan.ranges_m.size() == 4);
  CHECK(make_scan(scan, four_beams()).invalid == 4);
  CloudMessage rows;
  rows.height = std::numeric_limits<std::uint32_t>::max();  // of no points each
  CHECK(sliced(CloudSlicer(four_beams()), rows).ranges_m.size() == 4);
}
