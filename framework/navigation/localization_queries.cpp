#include "navigation/localization_queries.hpp"

#include <algorithm>
#include <utility>

namespace opal::navigation {

void LocalizerQueries::begin() {
  localizer_.reset();
  scan_ = {};
  estimate_ = {};
  keep_pattern_ = false;
}

void LocalizerQueries::take(const RawScan& scan) {
  if (std::exchange(keep_pattern_, false)) localizer_.keep_pattern();
  T_odom_base_ = of_three_numbers(*scan.T_odom_base);
  scan_ = make_scan(scan, laser_);
  localizer_.update(sample_of(scan_, T_odom_base_, laser_.T_base_laser));
  estimate_ = localizer_.estimate_at(scan_.stamp_s, T_odom_base_);
  estimate_.T_map_base = of_three_numbers(estimate_.T_map_base);
  for (PoseEstimate::Alternative& alternative : estimate_.alternatives)
    alternative.T_map_base = of_three_numbers(alternative.T_map_base);
}

std::vector<Geometry> LocalizerQueries::pattern() const {
  std::vector<Geometry> pattern;
  const std::vector<Hypothesis> hypotheses = localizer_.hypotheses();
  if (hypotheses.empty()) return pattern;
  const Pose2 T_base_local = localizer_.local_map().T_local_base_at(T_odom_base_).inverse();
  const auto& features = localizer_.local_map().features();
  for (const Association& association : hypotheses.front().associations) {
    if (!association.map_feature.exists()) continue;
    const auto local = std::find_if(features.begin(), features.end(),
                                    [&](const LocalFeature& f) { return f.id == association.local_feature; });
    if (local != features.end()) pattern.push_back(transformed(T_base_local, local->feature.geometry));
  }
  return pattern;
}

}  // namespace opal::navigation
