#pragma once

#include <algorithm>
#include <optional>

namespace opal::ros2 {

/// How long transforms are waited for, where a topic has odometry, too. Drivers may start later than this program, so
/// time counts from what is heard of them.
class OdometryPatience {
 public:
  /// Transforms usually begin at once: after this time odometry may come from its topic.
  static constexpr double kWaitForTransformsS = 3;

  /// Somebody publishes transforms, and they are read. All times are by one steady clock.
  void transforms_are_read(double now_s) { transforms_since_s_ = transforms_since_s_.value_or(now_s); }
  /// A message of the topic of odometry.
  void odometry_is_heard(double now_s) { odometry_since_s_ = odometry_since_s_.value_or(now_s); }
  bool is_over(double now_s) const {
    if (!odometry_since_s_) return false;
    return now_s - std::max(*odometry_since_s_, transforms_since_s_.value_or(*odometry_since_s_)) > kWaitForTransformsS;
  }

 private:
  std::optional<double> transforms_since_s_, odometry_since_s_;
};

}  // namespace opal::ros2
