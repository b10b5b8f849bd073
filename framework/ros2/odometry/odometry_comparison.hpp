#pragma once

#include <opal/sensing/log_source.hpp>

#include <optional>
#include <string>

namespace opal::ros2 {

/// Messages and transforms that both say where the robot is in the frame of odometry. Transforms of others build on the
/// transform, so a pose by other odometry makes them wrong.
class OdometryComparison {
 public:
  void hear_message(const OdometryRecord& odometry) { message_ = odometry; }
  void hear_transform(const OdometryRecord& odometry);
  /// By how much they differ at the same time, in words; empty: not by much, or there is only one.
  const std::string& difference() const { return difference_; }

 private:
  std::optional<OdometryRecord> message_;
  std::string difference_;
};

}  // namespace opal::ros2
