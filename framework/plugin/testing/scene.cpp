#include "plugin/testing/scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <random>

namespace opal::testing {
namespace {

constexpr int kBeams = 541;
constexpr double kFirstBearing_rad = -0.75 * std::numbers::pi;
constexpr double kIncrement_rad = 1.5 * std::numbers::pi / (kBeams - 1);
constexpr double kRangeMax_m = 12;
constexpr double kSigma_m = 0.01;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Range at which a ray meets a surface.
struct RangeAlong {
  Point origin, direction;

  double operator()(const Segment& s) const {
    const Point along = s.end - s.begin;
    const double denominator = cross(direction, along);
    if (std::abs(denominator) < 1e-12) return kNever;
    const double range = cross(s.begin - origin, along) / denominator;
    const double share = cross(s.begin - origin, direction) / denominator;
    return range > 0 && share >= 0 && share <= 1 ? range : kNever;
  }
  double operator()(const Circle& c) const {
    const Point way = c.center - origin;
    const double nearest = way.dot(direction);
    const double half_chord_squared = c.radius_m * c.radius_m - (way - nearest * direction).squaredNorm();
    if (half_chord_squared < 0 || nearest <= 0) return kNever;
    return nearest - std::sqrt(half_chord_squared);
  }
  template <class Other>
  double operator()(const Other&) const {
    return kNever;
  }
};

double first_range(std::span<const Geometry> surfaces, const Point& origin, const Point& direction) {
  double range = kNever;
  for (const Geometry& surface : surfaces) range = std::min(range, std::visit(RangeAlong{origin, direction}, surface));
  return range;
}

std::string text(const Point& p) { return fmt::format("({:.2f}, {:.2f})", p.x(), p.y()); }

struct Describe {
  std::string operator()(const Point& p) const { return "a point at " + text(p); }
  std::string operator()(const OrientedPoint& p) const { return "an oriented point at " + text(p.position); }
  std::string operator()(const Segment& s) const { return "a segment from " + text(s.begin) + " to " + text(s.end); }
  std::string operator()(const Circle& c) const {
    return "a circle at " + text(c.center) + " with radius " + std::to_string(c.radius_m);
  }
};

struct IsPossible {
  bool operator()(const Point& p) const { return p.allFinite(); }
  bool operator()(const OrientedPoint& p) const {
    return p.position.allFinite() && std::isfinite(p.heading_rad) && p.opening_rad > 0 &&
           p.opening_rad < 2 * std::numbers::pi;
  }
  bool operator()(const Segment& s) const { return s.begin.allFinite() && s.end.allFinite() && s.length_m() > 0; }
  bool operator()(const Circle& c) const { return c.center.allFinite() && std::isfinite(c.radius_m) && c.radius_m > 0; }
};

}  // namespace

Scan simulated_scan(std::span<const Geometry> surfaces, const Pose2& T_surfaces_laser, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, kSigma_m);
  Scan scan;
  scan.angle_increment_rad = kIncrement_rad;
  scan.range_max_m = kRangeMax_m;
  for (int beam = 0; beam < kBeams; ++beam) {
    const double bearing = kFirstBearing_rad + beam * kIncrement_rad;
    const Point direction = T_surfaces_laser.rotate(unit_vector(bearing));
    const double range = first_range(surfaces, T_surfaces_laser.position(), direction) + noise(random);
    if (range > kRangeMax_m)
      scan.free_bearings_rad.push_back(bearing);
    else if (range > 0.05)
      scan.points.push_back({range * unit_vector(bearing), range, bearing, beam});
    else
      ++scan.invalid;
  }
  return scan;
}

Scan turned(const Scan& scan, double turn_rad) {
  Scan result = scan;
  const Pose2 turn(0, 0, turn_rad);
  for (ScanPoint& point : result.points) {
    point.position = turn * point.position;
    point.bearing_rad += turn_rad;
  }
  for (double& bearing : result.free_bearings_rad) bearing += turn_rad;
  return result;
}

std::vector<Geometry> room(const std::vector<Point>& corners_counter_clockwise) {
  std::vector<Geometry> faces;
  const std::size_t n = corners_counter_clockwise.size();
  for (std::size_t i = 0; i < n; ++i)
    faces.push_back(Segment{corners_counter_clockwise[i], corners_counter_clockwise[(i + 1) % n]});
  return faces;
}

std::vector<Geometry> example_room() {
  std::vector<Geometry> surfaces = room({{0, 0}, {3, 0}, {3, -1}, {4.5, -1}, {4.5, 0}, {7, 0}, {7, 5}, {0.5, 4.6}});
  const std::vector<Point> pillar{{2, 3}, {2, 3.4}, {2.4, 3.4}, {2.4, 3}};  // clockwise: seen from outside
  for (const Geometry& face : room(pillar)) surfaces.push_back(face);
  surfaces.push_back(Circle{{5, 2}, 0.25});
  surfaces.push_back(Circle{{5.5, 3.7}, 0.15});
  surfaces.push_back(Circle{{1.2, 1.0}, 0.04});
  return surfaces;
}

bool is_finite(const Pose2& pose) { return pose.position().allFinite() && std::isfinite(pose.heading_rad()); }

std::string described(const Geometry& geometry) { return std::visit(Describe{}, geometry); }

bool is_possible(const Geometry& geometry) { return std::visit(IsPossible{}, geometry); }

}  // namespace opal::testing
