#include "synthetic.hpp"

#include "navigation/path.hpp"

#include <catch2/catch.hpp>

#include <random>

using namespace opal;
using namespace opal::navigation;

namespace {

std::vector<Obstacle> wall(const Point& from, const Point& to) {
  std::vector<Obstacle> points;
  const int count = 1 + static_cast<int>((to - from).norm() / 0.02);
  for (int k = 0; k <= count; ++k) points.push_back({from + (to - from) * (static_cast<double>(k) / count)});
  return points;
}

}  // namespace

TEST_CASE("no free primitive leads through a wall, or nearer to it than the margin") {
  const MotionPrimitives motion(MotionOptions{.omnidirectional = GENERATE(false, true)});
  std::mt19937 random(4);
  std::uniform_real_distribution<double> angle(-3.1, 3.1), range(0.4, 1.5);
  for (int k = 0; k < 50; ++k) {
    const double bearing = angle(random), distance = range(random);
    const Point foot = distance * unit_vector(bearing), along = 3 * left_of(unit_vector(bearing));
    const std::vector<Obstacle> points = wall(foot - along, foot + along);
    const double keep = std::min(distance, motion.options().radius_m + motion.options().margin_m);
    for (const MotionPrimitive& primitive : motion.all()) {
      if (!motion.is_free(primitive, points)) continue;
      for (const Pose2& footprint : primitive.footprints)
        CHECK(distance - unit_vector(bearing).dot(footprint.position()) > keep - 0.01);
    }
  }
}

TEST_CASE("where nothing is, the robot drives straight to what is ahead and turns to what is behind") {
  const MotionPrimitives motion;
  const auto ahead = motion.towards({3, 0}, {});
  REQUIRE(ahead);
  CHECK(ahead->linear_mps.x() == Approx(motion.options().speed_mps));
  CHECK(ahead->turn_radps == 0);
  const auto behind = motion.towards({-2, 0.3}, {});
  REQUIRE(behind);
  CHECK(behind->turn_radps > 0);
}

TEST_CASE("along a path the robot keeps its speed round a bend, stays on the path, and stops at its end") {
  const MotionPrimitives motion;
  const double turn = GENERATE(-1, 1);
  std::vector<Point> path;  // a quarter of a circle of 1.5 m, and on
  for (double angle = 0; angle < std::numbers::pi / 2; angle += 0.1)
    path.push_back({1.5 * std::sin(angle), turn * 1.5 * (1 - std::cos(angle))});
  path.push_back({1.5, turn * 4});
  Pose2 robot;
  Velocity before;
  double driven_m = 0;
  int steps = 0;
  for (; steps < 100 && (robot.position() - path.back()).norm() > 0.15; ++steps) {
    const PlaceOnPath here = nearest_on_path(path, robot.position());
    CHECK(here.off_m < 0.15);
    std::vector<Point> left{here.position};
    left.insert(left.end(), path.begin() + static_cast<std::ptrdiff_t>(here.piece + 1), path.end());
    for (Point& p : left) p = robot.inverse() * p;
    const auto velocity = motion.along(left, {}, before);
    REQUIRE(velocity);
    before = *velocity;
    robot = robot * moved(*velocity, 0.1);
    driven_m += 0.1 * velocity->linear_mps.norm();
  }
  CHECK(steps < 100);
  CHECK(driven_m / (0.1 * steps) > 0.75 * motion.options().speed_mps);
}

TEST_CASE("a robot turns on the spot to a path that leads back") {
  const MotionPrimitives motion;
  const std::vector<Point> path{{0, 0}, {-3, 0.2}};
  const auto velocity = motion.along(path, {});
  REQUIRE(velocity);
  CHECK(velocity->turn_radps > 0.5);
  CHECK(velocity->linear_mps.x() < 0.2);
}

TEST_CASE("a robot that is too near to something may turn and go away, but not nearer") {
  const MotionPrimitives motion;
  const std::vector<Obstacle> points = wall({0.33, -1}, {0.33, 1});
  const auto on = motion.towards({2, 0}, points);
  CHECK((!on || on->linear_mps.x() <= 0));
  CHECK(motion.towards({-2, 0.1}, points));
}

TEST_CASE("a gap wider than the robot is room, a narrower one is not") {
  const MotionPrimitives motion;
  const auto gap = [](double width) {
    std::vector<Point> points;
    for (const Obstacle& p : wall({1, width / 2}, {1, 3})) points.push_back(p.position);
    for (const Obstacle& p : wall({1, -3}, {1, -width / 2})) points.push_back(p.position);
    return points;
  };
  CHECK(motion.room_m(0, gap(0.8), 5) == 5);
  CHECK(motion.room_m(0, gap(0.6), 5) < 1);
}

TEST_CASE("what was seen ahead is still known when it is beside or behind, and what is gone is forgotten") {
  const LaserModel laser = wide_laser();
  const auto map = std::make_shared<const MapView>(map_of(room_of({{0, 0}, {3, 0}, {3, 2}, {0, 2}})), "PlanarLidar2D");
  SeenObstacles obstacles;
  const Pose2 before(1.5, 1, 0), now(1.5, 1, std::numbers::pi);
  obstacles.add(seen(*map, laser, before, 0), before, laser.T_base_laser);
  obstacles.add(seen(*map, laser, now, 3), now, laser.T_base_laser);
  const std::vector<Obstacle> near = obstacles.near(2);
  const auto behind = [](const Obstacle& p) { return p.position.x() < -1 && std::abs(p.position.y()) < 0.2; };
  CHECK(std::any_of(near.begin(), near.end(), behind));

  SeenObstacles open;
  Scan person = seen(*map, laser, before, 0);
  for (ScanPoint& p : person.points)
    if (std::abs(p.bearing_rad) < 0.1) p = {0.5 * unit_vector(p.bearing_rad), 0.5, p.bearing_rad, p.beam};
  const auto in_front = [&](const Point& p) { return (p - before * Point(0.7, 0)).norm() < 0.15; };
  std::vector<Point> standing;
  for (int scan = 0; scan < 3; ++scan) {
    standing = open.standing(5);
    CHECK(standing.empty());  // a single scan may err
    open.add(person, before, laser.T_base_laser);
    person.stamp_s += 0.1;
  }
  standing = open.standing(5);
  CHECK(std::any_of(standing.begin(), standing.end(), in_front));
  open.add(seen(*map, laser, before, 1), before, laser.T_base_laser);
  standing = open.standing(5);
  CHECK(std::none_of(standing.begin(), standing.end(), in_front));
}

namespace {

/// A wall at 0.5 m on the right, 2 m long, that is a pane where `sends_back` says no: there the beams end 2 m behind
/// it.
Scan beside_pane(double stamp_s, const std::function<bool(int)>& sends_back) {
  Scan scan;
  scan.stamp_s = stamp_s;
  for (int k = -90; k <= 90; ++k) {
    const double bearing_rad = -std::numbers::pi / 2 + k * std::numbers::pi / 360;
    const double range_m = (sends_back(k) ? 0.5 : 2.5) / std::cos(bearing_rad + std::numbers::pi / 2);
    scan.points.push_back({Point(range_m * unit_vector(bearing_rad)), range_m, bearing_rad});
  }
  return scan;
}

double widest_berth_m(const SeenObstacles& seen) {
  double widest_m = 0;
  for (const Obstacle& obstacle : seen.near(1)) widest_m = std::max(widest_m, obstacle.berth_m);
  return widest_m;
}

}  // namespace

TEST_CASE("a pane that sends back some beams now and then stands still, who steps before it moves") {
  SeenObstacles seen;
  // Every 1.2 s a strip of the pane sends beams back in one scan.
  for (int k = 0; k < 200; ++k)
    seen.add(beside_pane(0.1 * k, [&](int beam) { return k % 12 == 0 && beam > -20 && beam < 20; }), Pose2(), Pose2());
  seen.add(beside_pane(20, [](int beam) { return beam > -20 && beam < 20; }), Pose2(), Pose2());
  CHECK(widest_berth_m(seen) == 0);
  seen.add(beside_pane(20.6, [](int beam) { return beam > 40 && beam < 70; }), Pose2(), Pose2());
  CHECK(widest_berth_m(seen) > 0);
}
