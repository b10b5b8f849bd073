#pragma once

#include "navigation/blackboard.hpp"

namespace opal::navigation {

/// What has been seen makes the floor dear where the robot has no room for it, and near what is not mapped, and where
/// it got stuck, but for where it has just been itself; frame `map`, by the best hypothesis.
FloorGrid::Surcharge unmapped_surcharge(const Blackboard& blackboard);

/// Follows a path, frame odom, by motion primitives.
class PathDrive {
 public:
  explicit PathDrive(std::vector<Point> path_odom) : path_(std::move(path_odom)) {}
  /// @param T_odom_map  turns a path in the map frame into one in the odom frame.
  PathDrive(const Pose2& T_odom_map, const std::vector<Point>& path_map);

  bool arrived(const Blackboard& blackboard, double within_m) const;
  /// Asks the situation for the next velocity.
  void drive(Blackboard& blackboard);
  const std::vector<Point>& path() const { return path_; }

 private:
  std::vector<Point> path_;
  std::size_t passed_ = 0;  ///< points of the path that lie behind
};

}  // namespace opal::navigation
