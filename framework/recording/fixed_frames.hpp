#pragma once

#include "recording/ros_messages.hpp"

#include <map>

namespace opal::recording {

/// The frames that are fixed to each other.
class FixedFrames {
 public:
  void add(const Transform& transform);
  /// The same, but what carries a frame already stays.
  void add_unless_known(const Transform& transform) {
    if (!by_child_.contains(without_slash(transform.child))) add(transform);
  }
  /// The pose of a frame in another one that is fixed to it; nullopt if there is no connection.
  std::optional<Eigen::Isometry3d> pose(const std::string& parent, const std::string& child) const;
  /// The frame at the bottom of what carries `frame`.
  std::string root_of(const std::string& frame) const { return up_from(frame).parent; }

 private:
  /// From a frame up to its root, as one transform.
  Transform up_from(const std::string& frame) const;

  std::map<std::string, Transform> by_child_;
};

/// All transforms that a recording states.
class SeenTransforms {
 public:
  struct Seen {
    Transform first;
    Transform last;  ///< of static ones the one that holds
    std::string topic;
    int messages = 0;
    bool is_static = false;  ///< by its topic
    bool moves = false;
  };

  void add(const Transform& transform, const std::string& topic, bool is_static);
  /// By parent and child, without slashes.
  const std::map<std::pair<std::string, std::string>, Seen>& by_link() const { return by_link_; }
  /// Those that are static and, where no such link carries a frame, those that were never seen to move.
  FixedFrames fixed_frames() const;

 private:
  std::map<std::pair<std::string, std::string>, Seen> by_link_;
};

}  // namespace opal::recording
