#include "recording/fixed_frames.hpp"

namespace opal::recording {

void FixedFrames::add(const Transform& transform) {
  Transform& kept = by_child_[without_slash(transform.child)];
  kept = transform;
  kept.parent = without_slash(transform.parent);
}

Transform FixedFrames::up_from(const std::string& frame) const {
  Transform whole;
  whole.parent = whole.child = without_slash(frame);
  // A damaged log may contain a cycle: no path visits more frames than there are.
  for (std::size_t steps = 0; steps < by_child_.size(); ++steps) {
    const auto step = by_child_.find(whole.parent);
    if (step == by_child_.end()) break;
    whole.T_parent_child = step->second.T_parent_child * whole.T_parent_child;
    whole.parent = step->second.parent;
  }
  return whole;
}

std::optional<Eigen::Isometry3d> FixedFrames::pose(const std::string& parent, const std::string& child) const {
  const Transform parent_up = up_from(parent);
  const Transform child_up = up_from(child);
  if (parent_up.parent != child_up.parent) return std::nullopt;
  return parent_up.T_parent_child.inverse() * child_up.T_parent_child;
}

bool is_same_place(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  constexpr double kNoise_m = 1e-3, kNoiseCosine = 1 - 1e-6;  // 1 mm, 0.08 degrees
  const double turn_cosine = ((a.linear().transpose() * b.linear()).trace() - 1) / 2;
  return (a.translation() - b.translation()).norm() < kNoise_m && turn_cosine > kNoiseCosine;
}

void SeenTransforms::add(const Transform& transform, const std::string& topic, bool is_static) {
  const std::pair<std::string, std::string> link{without_slash(transform.parent), without_slash(transform.child)};
  auto [seen, is_new] = by_link_.try_emplace(link, Seen{transform, transform, topic, 0, is_static, false});
  ++seen->second.messages;
  if (!is_new && !is_same_place(seen->second.first.T_parent_child, transform.T_parent_child)) seen->second.moves = true;
  seen->second.last = transform;
}

FixedFrames SeenTransforms::fixed_frames() const {
  FixedFrames frames;
  for (const auto& [link, seen] : by_link_)
    if (seen.is_static) frames.add(seen.last);
  for (const auto& [link, seen] : by_link_)
    if (!seen.is_static && !seen.moves) frames.add_unless_known(seen.last);
  return frames;
}

}  // namespace opal::recording
