#include "localization/search/map_search.hpp"

#include <cmath>
#include <utility>

namespace opal {

void MapSearch::hint(const PoseHint& hint) {
  const bool is_finite = hint.T_map_base.position().allFinite() && std::isfinite(hint.T_map_base.heading_rad()) &&
                         std::isfinite(hint.sigma_m) && std::isfinite(hint.sigma_rad);
  if (is_finite) hint_ = hint;
}

std::vector<GlobalSearch::Result> MapSearch::look(const GlobalSearch::Scene& scene, const Pose2& T_odom_base,
                                                  const Need& need, StageTimes& times) {
  const bool is_time = schedule_.time_to_search(T_odom_base, need.at_once || hint_, need.every);
  std::vector<GlobalSearch::Result> found;
  if (scene.observation.points() < GlobalSearch::kFewestPoints) return found;
  if (hint_) found.push_back(search_.look_near(*std::exchange(hint_, {}), scene, times));
  if (is_time && (!ongoing_ || need.anew)) ongoing_ = search_.begin(scene, need.under_constrained, times);
  if (!ongoing_) return found;
  if (std::optional<GlobalSearch::Result> all = search_.go_on(*ongoing_, scene, times)) {
    ongoing_.reset();
    found.push_back(std::move(*all));
  }
  return found;
}

void MapSearch::restart() {
  abandon();
  schedule_.reset();
}

}  // namespace opal
