#pragma once

#include "tests/live/live_robot.hpp"

#include <opal/localization/localizer.hpp>
#include <opal/sensing/scan_pairing.hpp>

#include <vector>

/// Samples of a small simulated drive.
namespace opal::made {

inline Pose2 truth_at(const Sample& sample) { return robot().truth_at(sample.stamp_s); }

/// Keyframes of the robot's drive, by the seconds since it began.
inline std::vector<Sample> samples_between(double from_s, double to_s) {
  const LocalizerParts parts = robot().parts();
  ScanPairing pairing(parts.lasers);
  std::vector<Sample> samples;
  double first_s = -1;
  for (const simulation::Arrival& arrival : robot().arrivals) {
    pairing.take(arrival.record);
    while (const auto sample = pairing.next()) {
      if (first_s < 0) first_s = sample->stamp_s;
      const double at_s = sample->stamp_s - first_s;
      const bool is_apart =
          samples.empty() || parts.keyframes.are_apart(samples.back().T_odom_base, sample->T_odom_base);
      if (at_s >= from_s && at_s < to_s && is_apart) samples.push_back(*sample);
    }
  }
  return samples;
}

/// What a localizer says that knows where the robot is.
inline PoseEstimate estimate_of(const Sample& sample, Status status, const Pose2& off = {}) {
  PoseEstimate estimate;
  estimate.stamp_s = sample.stamp_s;
  estimate.status = status;
  estimate.has_pose = true;
  estimate.T_map_base = truth_at(sample) * off;
  estimate.covariance = Eigen::Vector3d(0.05, 0.05, 0.02).cwiseAbs2().asDiagonal();
  return estimate;
}

}  // namespace opal::made
