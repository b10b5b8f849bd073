#include "local_map/matched_points.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;

namespace {

constexpr double kLeg_m = 0.1;

/// Of the same number of points from each side.
void append_leg(std::vector<Point>& points, const Point& middle) {
  for (int k = -2; k <= 2; ++k) points.push_back(middle + Point(0, k * kLeg_m / 4));
}

/// A wall to the right, a leg ahead, a wall to the left; the robot drives along x.
Keyframe seen_at(double x_m, const Point& leg) {
  Keyframe keyframe;
  keyframe.T_local_base = Pose2(x_m, 0, 0);
  keyframe.driven_m = x_m;
  for (int k = 0; k < 40; ++k) keyframe.points.push_back(Point(0.1 * k, -1.5));
  append_leg(keyframe.points, leg - Point(x_m, 0));
  for (int k = 40; k-- > 0;) keyframe.points.push_back(Point(0.1 * k, 1.5));
  return keyframe;
}

std::ptrdiff_t points_ahead(const std::deque<Keyframe>& keyframes) {
  const std::vector<Point> points = matched_points(keyframes.back().T_local_base.position(), keyframes);
  CHECK(points.size() > 70);  // the walls
  return std::count_if(points.begin(), points.end(), [](const Point& p) { return std::abs(p.y()) < 1; });
}

}  // namespace

TEST_CASE("a person who walks along with the robot is not matched, one thing that stands is") {
  std::deque<Keyframe> with_person, with_post;
  for (const double x_m : {0.0, 0.5, 1.0, 1.5}) {
    with_person.push_back(seen_at(x_m, {x_m + 2, 0}));
    with_post.push_back(seen_at(x_m, {4, 0}));
  }
  CHECK(points_ahead(with_person) == 0);
  CHECK(points_ahead(with_post) > 8);
}

TEST_CASE("what the first scan saw is matched, since nothing else could have seen it") {
  CHECK(points_ahead({seen_at(0, {2, 0})}) > 2);
}

TEST_CASE("keyframes without points, and points beyond reach, are no trouble") {
  CHECK(matched_points({0, 0}, {}).empty());
  CHECK(matched_points({0, 0}, {Keyframe{}, Keyframe{}}).empty());
  Keyframe far;
  far.points = {Point(1e6, 0), Point(0, 1e9)};
  CHECK(matched_points({0, 0}, {far, far}).empty());
}

TEST_CASE("what lies beyond one rim of the reach is not taken for what lies within the other one") {
  constexpr double kReach_m = 20;
  for (int quarter = 0; quarter < 4; ++quarter) {
    CAPTURE(quarter);
    const Pose2 turned(0, 0, quarter * std::numbers::pi / 2);
    Keyframe before, now;  // a wall that only the one has seen, a leg that only the other has
    for (int k = -15; k <= 15; ++k) before.points.push_back(turned * Point(-kReach_m - 0.05, 0.1 * k));
    for (int k = -2; k <= 2; ++k) now.points.push_back(turned * Point(kReach_m - 0.05, 0.05 * k));
    before.driven_m = 0, now.driven_m = 1;
    CHECK(matched_points({0, 0}, {before, now}).empty());
    before.points = now.points;
    CHECK(matched_points({0, 0}, {before, now}).size() == 10);
  }
}
