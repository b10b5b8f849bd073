#include "navigation/viewpoints.hpp"

#include <algorithm>

namespace opal::navigation {
namespace {

/// What all hypotheses expect from one pose of the robot; empty scans where one of them has no floor.
using ExpectedScans = std::vector<std::vector<double>>;

class Comparison {
 public:
  Comparison(const MapView& map, const LaserModel& laser, const FloorGrid& floor, std::span<const PossiblePlace> places,
             const DisambiguateOptions& options)
      : map_(map), laser_(laser), floor_(floor), places_(places), options_(options), here_(separations(Pose2())) {}

  /// Expected to be gained at a pose, frame base_link, weighted by what the pairs' probabilities are.
  double gain(const Pose2& T_base_there) const {
    const std::vector<double> there = separations(T_base_there);
    double sum = 0, all = 0;
    for (std::size_t i = 0, pair = 0; i < places_.size(); ++i)
      for (std::size_t j = i + 1; j < places_.size(); ++j, ++pair) {
        const double weight = places_[i].probability * places_[j].probability;
        sum += weight * std::max(0.0, there[pair] - here_[pair]);
        all += weight;
      }
    return all > 0 ? sum / all : 0;
  }

 private:
  std::vector<double> separations(const Pose2& T_base_there) const {
    ExpectedScans scans;
    for (const PossiblePlace& place : places_) {
      const Pose2 pose = place.T_map_base * T_base_there;
      const bool possible = floor_.nearest(pose.position()).has_value();
      scans.push_back(possible ? expected_ranges(map_, laser_, pose, options_.view_m) : std::vector<double>{});
    }
    std::vector<double> separations;
    for (std::size_t i = 0; i < scans.size(); ++i)
      for (std::size_t j = i + 1; j < scans.size(); ++j) separations.push_back(separation(scans[i], scans[j]));
    return separations;
  }

  const MapView& map_;
  const LaserModel& laser_;
  const FloorGrid& floor_;
  std::span<const PossiblePlace> places_;
  const DisambiguateOptions& options_;
  std::vector<double> here_;
};

/// Reachable cells some way apart, at most about 150 of them.
std::vector<int> candidates(const FloorGrid& floor, const FloorWays& ways) {
  constexpr double kMost = 150, kFarthest_m = 35, kLeastSpacing_m = 0.8;
  const double spacing_m = std::max(kLeastSpacing_m, std::sqrt(floor.area_m2() / kMost));
  const int every = std::max(1, static_cast<int>(spacing_m / floor.cell_m()));
  std::vector<int> chosen;
  for (int cell : floor.cells()) {
    const Point cells = floor.center_of(cell) / floor.cell_m();
    const auto on_raster = [&](double x) { return static_cast<long>(std::floor(x)) % every == 0; };
    if (on_raster(cells.x()) && on_raster(cells.y()) && ways.cost[cell] * floor.cell_m() < kFarthest_m)
      chosen.push_back(cell);
  }
  return chosen;
}

/// As the robot arrives there.
Pose2 arrival(const FloorGrid& floor, const FloorWays& ways, int cell) {
  constexpr int kSteps = 5;
  int before = cell;
  for (int k = 0; k < kSteps && ways.before[before] >= 0; ++k) before = ways.before[before];
  const Point way = floor.center_of(cell) - floor.center_of(before);
  return {floor.center_of(cell), std::atan2(way.y(), way.x())};
}

}  // namespace

std::vector<double> expected_ranges(const MapView& map, const LaserModel& laser, const Pose2& T_map_base, double view_m,
                                    int beams) {
  const Pose2 T_map_laser = T_map_base * laser.T_base_laser;
  const double field = laser.angle_increment_rad * (laser.beams - 1);
  std::vector<double> ranges;
  for (int k = 0; k < beams; ++k) {
    const Point target = T_map_laser * Point(view_m * unit_vector(laser.angle_min_rad + field * (k + 0.5) / beams));
    const MapView::Crossing met = map.first_crossing(T_map_laser.position(), target, 0);
    ranges.push_back(met.feature.exists() ? met.range_m : view_m);
  }
  return ranges;
}

double separation(std::span<const double> a, std::span<const double> b) {
  constexpr double kClearly_m = 0.4, kClearly = 0.05, kShare = 0.1;
  if (a.empty() != b.empty()) return 1;
  int differ = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (std::abs(a[k] - b[k]) > kClearly_m + kClearly * std::min(a[k], b[k])) ++differ;
  return a.empty() ? 0 : std::min(1.0, differ / (kShare * static_cast<double>(a.size())));
}

std::optional<Viewpoint> best_viewpoint(const MapView& map, const LaserModel& laser, const FloorGrid& floor,
                                        const FloorGrid::Surcharge& surcharge, std::span<const PossiblePlace> places,
                                        std::span<const Point> avoided, const DisambiguateOptions& options) {
  constexpr double kAvoided_m = 1.5, kDetour_m = 1.5;
  if (places.size() < 2) return std::nullopt;
  const auto ways = floor.ways(places[0].T_map_base.position(), surcharge);
  if (!ways) return std::nullopt;
  const Comparison comparison(map, laser, floor, places, options);
  const Pose2 T_base_map = places[0].T_map_base.inverse();
  int best = -1;
  double most = 0, separation = 0;
  for (int cell : candidates(floor, *ways)) {
    const Pose2 there = arrival(floor, *ways, cell);
    const auto tried = [&](const Point& p) { return (p - there.position()).norm() < kAvoided_m; };
    if (std::any_of(avoided.begin(), avoided.end(), tried)) continue;
    const double expense_m = kDetour_m + ways->cost[cell] * floor.cell_m();
    if (1 / expense_m <= most) continue;
    const double gain = comparison.gain(T_base_map * there);
    if (gain < options.least_separation || gain / expense_m <= most) continue;
    most = gain / expense_m;
    separation = gain;
    best = cell;
  }
  if (best < 0) return std::nullopt;
  return Viewpoint{floor.straightened(floor.along(*ways, best), surcharge), separation};
}

}  // namespace opal::navigation
