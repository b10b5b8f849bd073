#include "localization/observation/observation.hpp"

namespace opal {
namespace {

std::vector<const ScanPoint*> spaced(const std::vector<ScanPoint>& points, double spacing_m) {
  std::vector<const ScanPoint*> chosen;
  for (const ScanPoint& point : points)
    if (chosen.empty() || (point.position - chosen.back()->position).norm() >= spacing_m) chosen.push_back(&point);
  return chosen;
}

/// Evenly by their order.
ThinnedScan evenly(const std::vector<const ScanPoint*>& points, const Pose2& T_base_laser, std::size_t most) {
  const std::size_t n = std::min(most, points.size());
  ThinnedScan chosen;
  for (std::size_t k = 0; k < n; ++k) {
    const ScanPoint& point = *points[(2 * k + 1) * points.size() / (2 * n)];
    chosen.points.push_back(T_base_laser * point.position);
    chosen.beams.push_back(point.beam);
  }
  return chosen;
}

/// What is due to one who has `mine` of `all`.
std::size_t share(std::size_t most, std::size_t mine, std::size_t all) {
  return all == 0 ? most : (most * mine + all - 1) / all;
}

std::vector<ObservedScan> observed_scans(const LocalMap& local_map, const Sample& sample) {
  constexpr double kSpacing_m = 0.1;
  constexpr std::size_t kPoints = 100, kFreeBeams = 25;  // more say hardly more: neighbours share their errors
  std::vector<ThinnedScan> seen = thinned(sample, kSpacing_m, kPoints);
  std::size_t free_beams = 0;
  for (const LaserView& view : sample.views) free_beams += view.scan.free_bearings_rad.size();
  std::vector<ObservedScan> scans;
  for (std::size_t k = 0; k < sample.views.size(); ++k) {
    const auto& [laser, scan, T_base_laser] = sample.views[k];
    const std::size_t most_free = share(kFreeBeams, scan.free_bearings_rad.size(), free_beams);
    ObservedScan observed{.laser_position = T_base_laser.position(),
                          .points = std::move(seen[k].points),
                          .free_bearings_rad = thinned_bearings(scan.free_bearings_rad, T_base_laser, most_free),
                          .range_max_m = scan.range_max_m,
                          .beams = std::move(seen[k].beams)};
    observed.evidence_cells = local_map.evidence_cells(observed.points);
    scans.push_back(std::move(observed));
  }
  return scans;
}

}  // namespace

ThinnedScan thinned(const std::vector<ScanPoint>& points, const Pose2& T_base_laser, double spacing_m,
                    std::size_t most) {
  return evenly(spaced(points, spacing_m), T_base_laser, most);
}

std::vector<ThinnedScan> thinned(const Sample& sample, double spacing_m, std::size_t most) {
  std::vector<std::vector<const ScanPoint*>> apart;
  std::size_t all = 0;
  for (const LaserView& view : sample.views) {
    apart.push_back(spaced(view.scan.points, spacing_m));
    all += apart.back().size();
  }
  std::vector<ThinnedScan> scans;
  for (std::size_t k = 0; k < apart.size(); ++k)
    scans.push_back(evenly(apart[k], sample.views[k].T_base_laser, share(most, apart[k].size(), all)));
  return scans;
}

std::vector<Point> thinned_points(const Sample& sample, double spacing_m, std::size_t most) {
  std::vector<Point> points;
  for (const ThinnedScan& scan : thinned(sample, spacing_m, most))
    points.insert(points.end(), scan.points.begin(), scan.points.end());
  return points;
}

std::vector<double> thinned_bearings(const std::vector<double>& bearings_rad, const Pose2& T_base_laser,
                                     std::size_t most) {
  const std::size_t n = std::min(most, bearings_rad.size());
  std::vector<double> chosen;
  for (std::size_t k = 0; k < n; ++k)
    chosen.push_back(bearings_rad[(2 * k + 1) * bearings_rad.size() / (2 * n)] + T_base_laser.heading_rad());
  return chosen;
}

Observation observe(const LocalMap& local_map, const Sample& sample, SeenFeatures seen) {
  return {local_map, observed_scans(local_map, sample), std::move(seen.features), std::move(seen.views)};
}

}  // namespace opal
