#include "simulation/drives/path_follower.hpp"

#include <algorithm>

namespace opal::simulation {

void PathFollower::follow(std::vector<Point> path) {
  path_ = std::move(path);
  next_ = 0;
  look_ahead_m_ = options_.look_ahead_m;
}

Velocity PathFollower::steer(const Pose2& T_map_base) {
  while (next_ + 1 < path_.size() && (path_[next_] - T_map_base.position()).norm() < look_ahead_m_) ++next_;
  if (next_ + 1 == path_.size() && (path_[next_] - T_map_base.position()).norm() < options_.arrived_m) ++next_;
  if (arrived()) return {};
  const Point target = T_map_base.inverse() * path_[next_];
  const double bearing = std::atan2(target.y(), target.x());
  constexpr double kSideways_rad = 0.7, kGain_per_s = 2;
  Velocity velocity;
  velocity.turn_radps = std::clamp(kGain_per_s * bearing, -options_.turn_radps, options_.turn_radps);
  const double speed = std::min(options_.speed_mps, 0.1 + kGain_per_s * target.norm());
  if (drive_ == Drive::omnidirectional)
    velocity.linear_mps = speed * target.normalized();
  else if (std::abs(bearing) < kSideways_rad)
    velocity.linear_mps.x() = speed * (1 - std::abs(bearing) / kSideways_rad);
  return velocity;
}

}  // namespace opal::simulation
