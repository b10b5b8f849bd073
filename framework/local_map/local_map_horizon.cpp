#include "local_map/local_map_horizon.hpp"

#include "local_map/local_map_merging.hpp"

namespace opal {
namespace {

bool forget_measurements(LocalFeature& local, KeyframeId oldest_kept, KeyframeId superseded) {
  return std::erase_if(local.measurements,
                       [&](const Measurement& m) { return m.keyframe < oldest_kept || m.keyframe == superseded; }) > 0;
}

}  // namespace

double driven_between_m(const Pose2& a, const Pose2& b, const LocalMapOptions& options) {
  return distance_m(a, b) + options.horizon_m_per_rad * angle_between_rad(a, b);
}

bool newest_is_distinct(const std::deque<Keyframe>& keyframes, const LocalMapOptions& options) {
  if (keyframes.size() < 2) return true;
  const Pose2& newest = keyframes.back().T_local_base;
  const Pose2& before = keyframes[keyframes.size() - 2].T_local_base;
  return distance_m(before, newest) >= options.pose_change_m ||
         angle_between_rad(before, newest) >= options.pose_change_rad;
}

void forget(std::deque<Keyframe>& keyframes, std::vector<LocalFeature>& features, bool superseded,
            const LocalMapOptions& options) {
  KeyframeId superseded_id;
  if (superseded && keyframes.size() > 1) {
    superseded_id = keyframes[keyframes.size() - 2].id;
    keyframes.erase(keyframes.end() - 2);
  }
  while (keyframes.size() > 1 && keyframes.back().driven_m - keyframes.front().driven_m > options.horizon_m)
    keyframes.pop_front();
  const KeyframeId oldest = keyframes.front().id;
  for (LocalFeature& local : features)
    if (forget_measurements(local, oldest, superseded_id) && !local.measurements.empty())
      refresh(local, keyframes, options);
  std::erase_if(features, [](const LocalFeature& local) { return local.measurements.empty(); });
}

}  // namespace opal
