#pragma once

#include <opal/common/feature.hpp>
#include <opal/sensing/scan.hpp>

#include <limits>
#include <random>
#include <vector>

namespace opal::test {

/// Walls (seen from both sides) and columns in the frame of the sensor.
struct Scene {
  std::vector<Segment> walls;
  std::vector<Circle> columns;
};

struct Scanner {
  double angle_min_rad = -std::numbers::pi / 2;
  double angle_increment_rad = std::numbers::pi / 360;
  int beams = 361;
  double range_max_m = 30;
  double sigma_m = 0;
};

inline Scanner all_around(int beams = 720) { return {-std::numbers::pi, 2 * std::numbers::pi / beams, beams, 30, 0}; }

inline double range_to(const Segment& wall, const Point& beam) {
  const Point along = wall.end - wall.begin;
  const double det = cross(beam, along);
  if (std::abs(det) < 1e-12) return std::numeric_limits<double>::infinity();
  const double range = cross(wall.begin, along) / det;
  const double u = cross(wall.begin, beam) / det;
  return range > 0 && u >= 0 && u <= 1 ? range : std::numeric_limits<double>::infinity();
}

inline double range_to(const Circle& column, const Point& beam) {
  const double along = beam.dot(column.center);
  const double discriminant = column.radius_m * column.radius_m - column.center.squaredNorm() + along * along;
  if (discriminant < 0 || along < 0) return std::numeric_limits<double>::infinity();
  return along - std::sqrt(discriminant);
}

inline Scan scan_of(const Scene& scene, const Scanner& scanner, std::mt19937& random) {
  std::normal_distribution<double> noise(0, 1);
  Scan scan;
  scan.angle_increment_rad = scanner.angle_increment_rad;
  scan.range_max_m = scanner.range_max_m;
  for (int beam = 0; beam < scanner.beams; ++beam) {
    const double bearing = scanner.angle_min_rad + beam * scanner.angle_increment_rad;
    const Point direction = unit_vector(bearing);
    double range = std::numeric_limits<double>::infinity();
    for (const Segment& wall : scene.walls) range = std::min(range, range_to(wall, direction));
    for (const Circle& column : scene.columns) range = std::min(range, range_to(column, direction));
    if (range > scanner.range_max_m) {
      scan.free_bearings_rad.push_back(bearing);
      continue;
    }
    range += scanner.sigma_m * noise(random);
    scan.points.push_back({range * direction, range, bearing, beam});
  }
  return scan;
}

inline Scan scan_of(const Scene& scene, const Scanner& scanner) {
  std::mt19937 unused;
  return scan_of(scene, scanner, unused);
}

/// The same returns, had the sensor been turned: every point and bearing turned by `angle_rad`.
inline Scan turned(Scan scan, double angle_rad) {
  const Pose2 turn(0, 0, angle_rad);
  for (ScanPoint& p : scan.points) {
    p.position = turn * p.position;
    p.bearing_rad += angle_rad;
  }
  for (double& bearing : scan.free_bearings_rad) bearing += angle_rad;
  return scan;
}

inline Scene moved(const Pose2& T, Scene scene) {
  for (Segment& wall : scene.walls) wall = transformed(T, wall);
  for (Circle& column : scene.columns) column.center = T * column.center;
  return scene;
}

/// Outline of a closed polygon.
inline std::vector<Segment> outline(const std::vector<Point>& vertices) {
  std::vector<Segment> walls;
  for (std::size_t i = 0; i < vertices.size(); ++i) walls.push_back({vertices[i], vertices[(i + 1) % vertices.size()]});
  return walls;
}

/// An L-shaped room of 8 x 6 m around the sensor, with a column and a box in it.
inline Scene furnished_room() {
  Scene scene{outline({{-2, -3}, {6, -3}, {6, 3}, {2, 3}, {2, 1.5}, {-2, 1.5}}), {{{3.5, -1}, 0.3}}};
  const Pose2 T(3, 0.9, std::atan2(0.9, 3) + std::numbers::pi / 4);
  const auto box =
      outline({T * Point(-0.25, -0.25), T * Point(0.25, -0.25), T * Point(0.25, 0.25), T * Point(-0.25, 0.25)});
  scene.walls.insert(scene.walls.end(), box.begin(), box.end());
  return scene;
}

/// Points with random ranges, jumps, gaps and repetitions: clutter of the worst kind.
inline Scan clutter(int beams, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  Scan scan;
  scan.angle_increment_rad = 2 * std::numbers::pi / beams;
  scan.range_max_m = 30;
  double range = 5;
  for (int beam = 0; beam < beams; ++beam) {
    const double bearing = -std::numbers::pi + beam * scan.angle_increment_rad;
    const double dice = uniform(random);
    if (dice < 0.05) range = 0.05 + 20 * uniform(random);
    if (dice > 0.95) continue;
    if (dice > 0.9) {
      scan.free_bearings_rad.push_back(bearing);
      continue;
    }
    range = std::clamp(range + 0.03 * (uniform(random) - 0.5), 0.01, 29.9);
    scan.points.push_back({range * unit_vector(bearing), range, bearing, beam});
    if (dice > 0.85 && dice < 0.87) scan.points.push_back(scan.points.back());
  }
  return scan;
}

}  // namespace opal::test
