#pragma once

#include <opal/sensing/scan.hpp>

#include <random>
#include <vector>

/// Scans of drawn rooms, for the tests of scan matchers.
namespace room {

using opal::Point;
using opal::Pose2;
using opal::Segment;

inline double range_to(const Segment& wall, const Point& from, const Point& direction) {
  const Point along = wall.end - wall.begin;
  const double turn = opal::cross(direction, along);
  if (std::abs(turn) < 1e-12) return 1e9;
  const Point to_begin = wall.begin - from;
  const double range = opal::cross(to_begin, along) / turn;
  const double share = opal::cross(to_begin, direction) / turn;
  return range > 0 && share >= 0 && share <= 1 ? range : 1e9;
}

/// What 361 beams over 180 degrees hit, in the sensor frame, with range noise.
inline std::vector<Point> scan(const std::vector<Segment>& walls, const Pose2& pose, double sigma_m,
                               std::mt19937& random, double range_max_m = 20) {
  std::normal_distribution<double> noise(0, 1);
  std::vector<Point> points;
  for (int beam = 0; beam < 361; ++beam) {
    const Point direction = opal::unit_vector(-std::numbers::pi / 2 + beam * std::numbers::pi / 360);
    double range = 1e9;
    for (const Segment& wall : walls) range = std::min(range, range_to(wall, pose.position(), pose.rotate(direction)));
    if (range < range_max_m) points.push_back((range + sigma_m * noise(random)) * direction);
  }
  return points;
}

inline std::vector<Segment> box(double x, double y, double width, double depth) {
  const Point a(x, y), b(x + width, y), c(x + width, y + depth), d(x, y + depth);
  return {{a, b}, {b, c}, {c, d}, {d, a}};
}

/// An office of 8 m by 6 m with a door, a cupboard, a desk and a pillar.
inline std::vector<Segment> office() {
  std::vector<Segment> walls{{{0, 0}, {8, 0}}, {{8, 0}, {8, 2}}, {{8, 3}, {8, 6}},
                             {{8, 6}, {0, 6}}, {{0, 6}, {0, 0}}, {{11, 0}, {11, 6}}};
  for (const auto& furniture : {box(3, 5.4, 1.2, 0.6), box(5, 0, 1.6, 0.8), box(2.2, 2, 0.4, 0.4)})
    walls.insert(walls.end(), furniture.begin(), furniture.end());
  return walls;
}

/// Two bare walls, 2 m apart, longer than any beam.
inline std::vector<Segment> corridor() { return {{{-50, -1}, {50, -1}}, {{-50, 1}, {50, 1}}}; }

inline std::vector<Point> moved(const Pose2& T_a_b, std::vector<Point> points) {
  for (Point& p : points) p = T_a_b * p;
  return points;
}

}  // namespace room
