#pragma once

#include "simulation/odometry.hpp"

#include <vector>

namespace opal::simulation {

struct PathFollowerOptions {
  double speed_mps = 0.7;
  double turn_radps = 1.0;
  double look_ahead_m = 0.5;
  double close_look_ahead_m = 0.15;  ///< where a corner was cut
  double arrived_m = 0.15;
};

/// Velocities that keep a robot on a path: pure pursuit (Coulter 1992), turning in place where the path goes sideways.
class PathFollower {
 public:
  PathFollower(Drive drive, const PathFollowerOptions& options = {}) : drive_(drive), options_(options) {}

  /// @param path  frame `map`, from here to the goal.
  void follow(std::vector<Point> path);
  /// Keeps closer to this path from here on: a corner was cut.
  void keep_close() { look_ahead_m_ = options_.close_look_ahead_m; }
  bool arrived() const { return next_ >= path_.size(); }
  /// What to do at this pose; zero when it has arrived.
  Velocity steer(const Pose2& T_map_base);

 private:
  Drive drive_;
  PathFollowerOptions options_;
  std::vector<Point> path_;
  double look_ahead_m_ = options_.look_ahead_m;
  std::size_t next_ = 0;  ///< first point of the path that is not behind
};

}  // namespace opal::simulation
