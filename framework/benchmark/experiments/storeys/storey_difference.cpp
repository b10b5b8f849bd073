#include "benchmark/experiments/storeys/storey_difference.hpp"

#include <opal/map/storeys.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace opal::experiments {
namespace {

constexpr int kBeams = 90;
constexpr double kApart_m = 0.5, kElsewhere_m = 0.3;

std::vector<Pose2> poses_apart(std::span<const Pose2> poses) {
  std::vector<Pose2> apart;
  for (const Pose2& pose : poses)
    if (apart.empty() || distance_m(apart.back(), pose) >= kApart_m) apart.push_back(pose);
  return apart;
}

/// Range of a beam among what is mapped.
double mapped_range_m(const MapView& map, const Pose2& T_map_laser, double bearing_rad, double most_m) {
  const Point& eye = T_map_laser.position();
  const auto wall = map.first_crossing(eye, eye + most_m * unit_vector(T_map_laser.heading_rad() + bearing_rad), 0);
  return wall.feature.exists() ? wall.range_m : most_m;
}

/// Share of the beams that end elsewhere at the second pose.
double difference(const MapView& map, const Pose2& T_map_laser, const Pose2& other, const LaserModel& laser) {
  const double sector_rad = (laser.beams - 1) * laser.angle_increment_rad;
  int elsewhere = 0;
  for (int k = 0; k < kBeams; ++k) {
    const double bearing_rad = laser.angle_min_rad + k * sector_rad / (kBeams - 1);
    elsewhere += std::abs(mapped_range_m(map, T_map_laser, bearing_rad, laser.range_max_m) -
                          mapped_range_m(map, other, bearing_rad, laser.range_max_m)) > kElsewhere_m;
  }
  return elsewhere / static_cast<double>(kBeams);
}

}  // namespace

double storey_difference(const MapView& map, std::span<const Pose2> T_map_base, const LaserModel& laser) {
  const std::vector<Pose2> poses = poses_apart(T_map_base);
  if (poses.empty()) return 1;
  const MapStorey* const driven = storey_at(map.map(), poses.front().position());
  double least = 1;
  for (const MapStorey& other : map.map().origin().storeys) {
    if (other.id == driven->id) continue;
    double sum = 0;
    for (const Pose2& pose : poses)
      sum +=
          difference(map, pose * laser.T_base_laser, other.to_map(driven->to_storey(pose)) * laser.T_base_laser, laser);
    least = std::min(least, sum / static_cast<double>(poses.size()));
  }
  return least;
}

}  // namespace opal::experiments
