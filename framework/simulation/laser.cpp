#include "simulation/laser.hpp"

#include <algorithm>

namespace opal::simulation {
namespace {

/// True ranges, glass decided on; reach where nothing is.
std::vector<double> true_ranges(const RayCaster& solids, const LaserPath& path, const LaserModel& laser,
                                const LaserErrors& errors, Random& random) {
  std::vector<double> ranges(static_cast<std::size_t>(laser.beams));
  for (int beam = 0; beam < laser.beams; ++beam) {
    const double bearing = laser.angle_min_rad + beam * laser.angle_increment_rad;
    const Pose2 T_map_laser = path(beam);
    const Point direction = T_map_laser.rotate(unit_vector(bearing));
    RayHit hit = solids.cast(T_map_laser.position(), direction, laser.range_max_m);
    while (hit.solid >= 0 && solids.solids()[hit.solid].glass && !random.chance(errors.glass_share)) {
      constexpr double kBeyond_m = 1e-6;
      hit = solids.cast_beyond(T_map_laser.position(), direction, hit.range_m + kBeyond_m, laser.range_max_m);
    }
    ranges[beam] = hit.solid < 0 ? laser.range_max_m : hit.range_m;
  }
  return ranges;
}

/// @param T_map_laser  about when the laser looks at the disc.
void put_before(std::vector<double>& ranges, const Circle& disc, const Pose2& T_map_laser, const LaserModel& laser) {
  const Point center = T_map_laser.inverse() * disc.center;
  const double distance = center.norm();
  if (distance <= disc.radius_m || distance - disc.radius_m > laser.range_max_m) return;
  const double middle = std::atan2(center.y(), center.x()), half = std::asin(disc.radius_m / distance);
  const double first = wrap_angle(middle - half - laser.angle_min_rad);
  const double from = first < 0 && first + 2 * half < 0 ? first + 2 * std::numbers::pi : first;
  const int low = std::max(0, static_cast<int>(std::ceil(from / laser.angle_increment_rad)));
  const int high = std::min(laser.beams - 1, static_cast<int>((from + 2 * half) / laser.angle_increment_rad));
  for (int beam = low; beam <= high; ++beam) {
    const double off = wrap_angle(laser.angle_min_rad + beam * laser.angle_increment_rad - middle);
    const double across = distance * std::sin(off);
    const double square = disc.radius_m * disc.radius_m - across * across;
    if (square < 0) continue;
    ranges[beam] = std::min(ranges[beam], distance * std::cos(off) - std::sqrt(square));
  }
}

/// The beam that looks at a point, as seen from the middle of the sweep.
int beam_at(const Point& point, const LaserPath& path, const LaserModel& laser) {
  const Point seen = path(laser.beams / 2).inverse() * point;
  double along_rad = std::fmod(std::atan2(seen.y(), seen.x()) - laser.angle_min_rad, 2 * std::numbers::pi);
  if (along_rad < 0) along_rad += 2 * std::numbers::pi;
  return std::min(static_cast<int>(along_rad / laser.angle_increment_rad), laser.beams - 1);
}

/// A beam has a width: at an edge, part of it meets what is in front and part what is behind.
void mix(std::vector<double>& ranges, const LaserErrors& errors, Random& random) {
  const std::vector<double> clean = ranges;
  for (std::size_t beam = 1; beam < clean.size(); ++beam) {
    if (std::abs(clean[beam] - clean[beam - 1]) < errors.mixed_step_m || !random.chance(errors.mixed_share)) continue;
    ranges[beam] = random.uniform(std::min(clean[beam], clean[beam - 1]), std::max(clean[beam], clean[beam - 1]));
  }
}

}  // namespace

RawScan swept(const RayCaster& solids, std::span<const Circle> discs, const LaserPath& T_map_laser,
              const LaserModel& laser, const LaserErrors& errors, Random& random) {
  std::vector<double> ranges = true_ranges(solids, T_map_laser, laser, errors, random);
  for (const Circle& disc : discs)
    put_before(ranges, disc, T_map_laser(beam_at(disc.center, T_map_laser, laser)), laser);
  mix(ranges, errors, random);
  RawScan scan;
  scan.ranges_m.reserve(ranges.size());
  for (double range : ranges) {
    const bool nothing = range >= laser.range_max_m || random.chance(errors.missed_share);
    const double sigma = std::hypot(errors.range_sigma_m, errors.range_sigma_share * range);
    const double reading = nothing ? laser.no_return_m : std::max(0.0, range + random.normal(sigma));
    scan.ranges_m.push_back(static_cast<float>(reading));
  }
  return scan;
}

}  // namespace opal::simulation
