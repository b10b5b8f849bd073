#pragma once

#include <opal/sensing/pose_hint.hpp>
#include <opal/sensing/scan.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace opal {

/// What one laser saw.
struct LaserView {
  int laser = 0;       ///< which of the robot's lasers, in the order of the deployment
  Scan scan;           ///< in the laser's frame when its sweep began
  Pose2 T_base_laser;  ///< where the laser was then, in the robot's frame at the sample's stamp
};

/// What somebody said since the sample before.
struct Said {
  bool forget = false;           ///< all samples before
  std::optional<PoseHint> hint;  ///< frame `map`; said after that
};

/// What a localizer takes: what the lasers saw at about one time, with the odometry then. It is one observation: each
/// scan keeps its own mount, field of view, range and time.
struct Sample {
  double stamp_s = 0;            ///< of the newest of the scans
  Pose2 T_odom_base;             ///< at that stamp; free of the jumps of recorded odometry if they are bridged
  std::vector<LaserView> views;  ///< by laser; at least one
  Pose2 T_odom_recorded;         ///< odometry at that stamp as it was recorded, with its jumps
  Said said = {};                ///< before it
};

/// The sample of a robot with one laser.
/// @param scan  in the sensor frame. @param T_odom_base  odometry at its stamp. @param T_base_laser  the mount.
inline Sample sample_of(Scan scan, const Pose2& T_odom_base, const Pose2& T_base_laser = {}) {
  const double stamp_s = scan.stamp_s;
  Sample sample{stamp_s, T_odom_base, {}, T_odom_base};
  sample.views.push_back({0, std::move(scan), T_base_laser});
  return sample;
}

}  // namespace opal
