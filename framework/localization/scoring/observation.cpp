#include "localization/scoring/observation.hpp"

namespace opal {

ThinnedScan thinned(const std::vector<ScanPoint>& points, const Pose2& T_base_laser, double spacing_m,
                    std::size_t most) {
  std::vector<const ScanPoint*> spaced;
  for (const ScanPoint& point : points)
    if (spaced.empty() || (point.position - spaced.back()->position).norm() >= spacing_m) spaced.push_back(&point);
  const std::size_t n = std::min(most, spaced.size());
  ThinnedScan chosen;
  for (std::size_t k = 0; k < n; ++k) {
    const ScanPoint& point = *spaced[(2 * k + 1) * spaced.size() / (2 * n)];
    chosen.points.push_back(T_base_laser * point.position);
    chosen.beams.push_back(point.beam);
  }
  return chosen;
}

std::vector<double> thinned_bearings(const std::vector<double>& bearings_rad, const Pose2& T_base_laser,
                                     std::size_t most) {
  const std::size_t n = std::min(most, bearings_rad.size());
  std::vector<double> chosen;
  for (std::size_t k = 0; k < n; ++k)
    chosen.push_back(bearings_rad[(2 * k + 1) * bearings_rad.size() / (2 * n)] + T_base_laser.heading_rad());
  return chosen;
}

Observation observe(const LocalMap& local_map, const Scan& scan, const Pose2& T_base_laser,
                    std::span<const Feature> features) {
  constexpr double kSpacing_m = 0.1;
  constexpr std::size_t kPoints = 100, kFreeBeams = 25;  // more say hardly more: neighbours share their errors
  ThinnedScan seen = thinned(scan.points, T_base_laser, kSpacing_m, kPoints);
  Observation observation{.local_map = local_map,
                          .points = std::move(seen.points),
                          .free_bearings_rad = thinned_bearings(scan.free_bearings_rad, T_base_laser, kFreeBeams),
                          .range_max_m = scan.range_max_m,
                          .laser_position = T_base_laser.position(),
                          .features = {},
                          .beams = std::move(seen.beams)};
  for (const Feature& feature : features) observation.features.push_back(transformed(T_base_laser, feature));
  observation.evidence_cells = local_map.evidence_cells(observation.points);
  return observation;
}

}  // namespace opal
