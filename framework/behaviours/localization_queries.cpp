#include "behaviours/localization_queries.hpp"

#include <algorithm>

namespace opal::behaviours {

void LocalizerQueries::take(const Scan& scan, const Pose2& T_odom_base) {
  localizer_.update(scan, T_odom_base);
  scan_ = scan;
  T_odom_base_ = T_odom_base;
  estimate_ = localizer_.estimate_at(scan.stamp_s, T_odom_base);
}

std::vector<Geometry> LocalizerQueries::pattern() const {
  std::vector<Geometry> pattern;
  const auto& hypotheses = localizer_.hypotheses();
  if (hypotheses.empty()) return pattern;
  const Pose2 T_base_local = localizer_.local_map().T_local_base_at(T_odom_base_).inverse();
  const auto& features = localizer_.local_map().features();
  for (const Association& association : hypotheses.front().associations) {
    if (association.map_feature < 0) continue;
    const auto local = std::find_if(features.begin(), features.end(),
                                    [&](const LocalFeature& f) { return f.id == association.local_feature; });
    if (local != features.end()) pattern.push_back(transformed(T_base_local, local->feature.geometry));
  }
  return pattern;
}

}  // namespace opal::behaviours
