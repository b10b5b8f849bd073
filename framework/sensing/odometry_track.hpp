#pragma once

#include <opal/common/geometry.hpp>

#include <deque>
#include <optional>

namespace opal {

/// The last stretch of odometry, made continuous, to be read at the stamps of scans.
class OdometryTrack {
 public:
  struct Limits {
    double max_speed_mps;
    double max_turn_radps;
    double jump_m;  // beyond what the speeds allow
    double jump_rad;
    bool bridge_jumps;
  };
  enum class Added { smooth, jumped };

  explicit OdometryTrack(const Limits& limits) : limits_(limits) {}

  /// @param stamp_s  not before the newest one; a record with the newest stamp replaces it.
  Added add(double stamp_s, const Pose2& T_odom_base);
  /// A reading that belongs to the track, but is used at its own stamp only.
  Added step_to(double stamp_s, const Pose2& T_odom_base);
  /// Goes on at another time, from the same place.
  void restart_clock();
  /// Forgets what is not needed to read the track at `stamp_s` or later.
  void forget_before(double stamp_s);

  /// Linear between two records; the nearest record within `reach_s` where there is none on one side.
  std::optional<Pose2> at(double stamp_s, double reach_s) const;
  /// `T_odom_base` in the continuous frame.
  Pose2 continuous(const Pose2& T_odom_base) const { return T_track_odom_ * T_odom_base; }
  /// The other way: as odometry says it since its last jump.
  Pose2 recorded(const Pose2& T_track_base) const { return T_track_odom_.inverse() * T_track_base; }
  bool reaches(double stamp_s) const { return !poses_.empty() && poses_.back().stamp_s >= stamp_s; }

 private:
  struct StampedPose {
    double stamp_s;
    Pose2 T_track_base;
  };

  bool is_jump(double stamp_s, const Pose2& T_track_base) const;

  Limits limits_;
  Pose2 T_track_odom_;
  std::deque<StampedPose> poses_;  // by stamp
  std::optional<StampedPose> last_;
  bool clock_restarted_ = false;
};

}  // namespace opal
