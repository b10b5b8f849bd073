#include "sensing/odometry_track.hpp"

#include <algorithm>
#include <cmath>

namespace opal {
bool OdometryTrack::is_jump(double stamp_s, const Pose2& T_track_base) const {
  if (!last_) return false;
  const double elapsed_s = clock_restarted_ ? 0 : std::max(stamp_s - last_->stamp_s, 0.0);
  return distance_m(last_->T_track_base, T_track_base) > limits_.jump_m + limits_.max_speed_mps * elapsed_s ||
         angle_between_rad(last_->T_track_base, T_track_base) > limits_.jump_rad + limits_.max_turn_radps * elapsed_s;
}

OdometryTrack::Added OdometryTrack::step_to(double stamp_s, const Pose2& T_odom_base) {
  const bool jumped = is_jump(stamp_s, continuous(T_odom_base));
  if (jumped && limits_.bridge_jumps) T_track_odom_ = last_->T_track_base * T_odom_base.inverse();
  last_ = {stamp_s, continuous(T_odom_base)};
  clock_restarted_ = false;
  return jumped ? Added::jumped : Added::smooth;
}

OdometryTrack::Added OdometryTrack::add(double stamp_s, const Pose2& T_odom_base) {
  const Added added = step_to(stamp_s, T_odom_base);
  if (reaches(stamp_s)) poses_.pop_back();
  poses_.push_back(*last_);
  return added;
}

void OdometryTrack::restart_clock() {
  poses_.clear();
  clock_restarted_ = true;
}

void OdometryTrack::forget_before(double stamp_s) {
  while (poses_.size() > 1 && poses_[1].stamp_s <= stamp_s) poses_.pop_front();
}

std::optional<Pose2> OdometryTrack::at(double stamp_s, double reach_s) const {
  const auto after = std::ranges::lower_bound(poses_, stamp_s, {}, &StampedPose::stamp_s);
  if (after != poses_.end() && after != poses_.begin()) {
    const StampedPose& before = *std::prev(after);
    const double share = (stamp_s - before.stamp_s) / (after->stamp_s - before.stamp_s);
    return interpolated(before.T_track_base, after->T_track_base, share);
  }
  if (poses_.empty()) return std::nullopt;
  const StampedPose& nearest = after == poses_.end() ? poses_.back() : *after;
  if (std::abs(nearest.stamp_s - stamp_s) > reach_s) return std::nullopt;
  return nearest.T_track_base;
}

}  // namespace opal
