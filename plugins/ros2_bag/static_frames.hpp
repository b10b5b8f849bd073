#pragma once

#include "messages.hpp"

#include <map>

namespace opal::ros2_bag {

/// Old drivers write "/base_link" for "base_link".
std::string without_slash(const std::string& frame);

/// The frames that are fixed to each other, from /tf_static.
class StaticFrames {
 public:
  void add(const Transform& transform);
  /// The pose of a frame in another one that is fixed to it; nullopt if there is no connection.
  std::optional<Eigen::Isometry3d> pose(const std::string& parent, const std::string& child) const;
  /// The frame at the bottom of what carries `frame`.
  std::string root_of(const std::string& frame) const { return up_from(frame).parent; }

 private:
  /// From a frame up to its root, as one transform.
  Transform up_from(const std::string& frame) const;

  std::map<std::string, Transform> by_child_;
};

}  // namespace opal::ros2_bag
