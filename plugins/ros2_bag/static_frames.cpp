#include "static_frames.hpp"

namespace opal::ros2_bag {

std::string without_slash(const std::string& frame) { return frame.starts_with('/') ? frame.substr(1) : frame; }

void StaticFrames::add(const Transform& transform) {
  Transform& kept = by_child_[without_slash(transform.child)];
  kept = transform;
  kept.parent = without_slash(transform.parent);
}

Transform StaticFrames::up_from(const std::string& frame) const {
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

std::optional<Eigen::Isometry3d> StaticFrames::pose(const std::string& parent, const std::string& child) const {
  const Transform parent_up = up_from(parent);
  const Transform child_up = up_from(child);
  if (parent_up.parent != child_up.parent) return std::nullopt;
  return parent_up.T_parent_child.inverse() * child_up.T_parent_child;
}

}  // namespace opal::ros2_bag
