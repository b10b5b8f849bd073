#include "localization/observation/observation.hpp"

#include "tests/localization/synthetic_scene.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace opal;
using namespace opal::synthetic;

namespace {

const Pose2 kInRoom(6.5, 4, 0.4);

/// A scan whose points lie one after the other, this far apart.
std::vector<ScanPoint> row_of(int number, double apart_m) {
  std::vector<ScanPoint> points;
  for (int k = 0; k < number; ++k) points.push_back({Point(apart_m * k, 1), 0, 0, 10 + k});
  return points;
}

}  // namespace

TEST_CASE("a thinned scan keeps its distances and no more points than asked for") {
  const auto points = row_of(100, 0.03);
  const ThinnedScan few = thinned(points, Pose2(), 0.1, 1000);
  for (std::size_t k = 1; k < few.points.size(); ++k) CHECK((few.points[k] - few.points[k - 1]).norm() >= 0.1);
  CHECK(thinned(points, Pose2(), 0.1, 7).points.size() == 7);
  CHECK(thinned(points, Pose2(), 0, 1000).points.size() == 100);
  CHECK(thinned({}, Pose2(), 0.1, 7).points.empty());
}

TEST_CASE("a scan is thinned evenly: no end of it is left out") {
  const ThinnedScan few = thinned(row_of(100, 1), Pose2(), 0.1, 10);
  REQUIRE(few.points.size() == 10);
  for (std::size_t k = 0; k < 10; ++k) CHECK(few.points[k].x() == Approx(10.0 * static_cast<double>(k) + 5).margin(1));
}

TEST_CASE("points of a thinned scan are in the base's frame and know their beams") {
  const Pose2 mount(0.5, 0, 0.5 * std::numbers::pi);
  const auto points = row_of(20, 1);
  const ThinnedScan few = thinned(points, mount, 0, 6);
  REQUIRE(few.beams.size() == few.points.size());
  for (std::size_t k = 0; k < few.points.size(); ++k) {
    const ScanPoint& original = points[static_cast<std::size_t>(few.beams[k] - 10)];
    CHECK((few.points[k] - mount * original.position).norm() == Approx(0).margin(1e-12));
  }
}

TEST_CASE("free bearings are turned with the mount and chosen evenly") {
  std::vector<double> bearings;
  for (int k = 0; k < 100; ++k) bearings.push_back(0.01 * k);
  const auto few = thinned_bearings(bearings, Pose2(1, 2, 0.5), 4);
  REQUIRE(few.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) CHECK(few[k] == Approx(0.5 + 0.125 + 0.25 * static_cast<double>(k)).margin(0.01));
  CHECK(thinned_bearings({}, Pose2(), 4).empty());
}

TEST_CASE("what is observed is where the map has it, in the base's frame") {
  const auto map = view_of(room());
  const Robot robot(map, kInRoom);
  const Observation seen = robot.observation();
  REQUIRE(seen.points() == 100);
  for (const Point& point : seen.scans.front().points) CHECK(map->clearance_m(kInRoom * point) < 0.15);
  REQUIRE(seen.features.size() == 5);
  const auto& column = std::get<Circle>(seen.features[0].geometry);
  CHECK((kInRoom * column.center - Point(3, 2.2)).norm() == Approx(0).margin(1e-9));
}

TEST_CASE("every observed point has a beam and an evidence cell, and there are few free bearings") {
  const auto map = view_of({{"opal:Wall", Segment{{0, 0}, {10, 0}}}});
  const Robot robot(map, Pose2(5, 2, 0));
  const Observation seen = robot.observation();
  REQUIRE(seen.scans.size() == 1);
  const ObservedScan& scan = seen.scans.front();
  CHECK_FALSE(scan.points.empty());
  CHECK(scan.beams.size() == scan.points.size());
  CHECK(scan.evidence_cells.size() == scan.points.size());
  CHECK(scan.free_bearings_rad.size() == 25);
}

TEST_CASE("the right hypothesis places the robot where it stands") {
  Robot robot(view_of(room()), kInRoom);
  robot.drive_to(kInRoom * Pose2(0.5, 0.1, 0.2));
  const Pose2 T_map_base = robot.observation().T_map_base(robot.truth().T_map_local);
  CHECK(distance_m(T_map_base, robot.T_map_base()) == Approx(0).margin(1e-9));
  CHECK(wrap_angle(T_map_base.heading_rad() - robot.T_map_base().heading_rad()) == Approx(0).margin(1e-9));
}

TEST_CASE("a feature is seen from the laser of its own scan") {
  const Robot robot(view_of(room()), kInRoom);
  const ObservedScan front{.laser_position = {0.3, 0}}, rear{.laser_position = {-0.4, 0.1}};
  const Observation seen{robot.local_map(), {front, rear}, {Feature(), Feature()}, {1, 0}};
  CHECK(seen.viewpoint_of(0) == rear.laser_position);
  CHECK(seen.viewpoint_of(1) == front.laser_position);
}

TEST_CASE("an empty scan is an empty observation") {
  Robot robot(view_of(room()), kInRoom);
  robot.drive_blind_to(kInRoom * Pose2(1, 0, 0));
  const Observation seen = robot.observation();
  CHECK(seen.points() == 0);
  CHECK(seen.features.empty());
  CHECK(seen.scans.front().free_bearings_rad.empty());
}
