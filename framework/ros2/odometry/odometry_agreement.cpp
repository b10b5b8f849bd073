#include "ros2/odometry/odometry_agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace opal::ros2 {
namespace {

// Between two looks at the way: longer than the time between messages, so that jitter and rates make no way.
constexpr double kStep_s = 0.5;
constexpr double kShare = 0.05;
// Less tells nothing: 5 % of it is as much as odometry's own noise.
constexpr double kEnough_m = 0.5, kEnough_rad = 0.5;

struct Motion {
  double driven_m = 0, turned_rad = 0;
};

/// By increasing stamp. Stamps of zero are of a driver without a clock, and cannot be compared.
void put_in_order(std::vector<StampedPose>& poses) {
  std::erase_if(poses, [](const StampedPose& pose) { return !(pose.stamp_s > 0); });
  std::ranges::stable_sort(poses, {}, &StampedPose::stamp_s);
}

Motion motion_of(const OdometrySource& source, double begin_s, double end_s) {
  Motion motion;
  const int steps = std::max(1, static_cast<int>((end_s - begin_s) / kStep_s));
  std::optional<Pose2> before;
  for (int k = 0; k <= steps; ++k) {
    const std::optional<Pose2> now =
        pose_at(source.T_odom_base, k == steps ? end_s : begin_s + k * (end_s - begin_s) / steps);
    if (!now) continue;
    if (before) motion.driven_m += distance_m(*before, *now);
    if (before) motion.turned_rad += angle_between_rad(*before, *now);
    before = now;
  }
  return motion;
}

bool differs(double a, double b, double enough) {
  return std::max(a, b) > enough && std::abs(a - b) > kShare * std::max(a, b);
}

std::string words_of(const OdometrySource& source, const Motion& motion) {
  return source.name + fmt::format(" says {:.2f} m and {:.0f} degrees", motion.driven_m, degrees(motion.turned_rad));
}

std::string frames_of(const OdometrySource& source) {
  return source.name + " says where " + (source.base_frame.empty() ? "an unnamed frame" : source.base_frame) +
         " is in " + (source.odom_frame.empty() ? "an unnamed frame" : source.odom_frame);
}

}  // namespace

std::vector<std::string> disagreements(OdometrySource used, OdometrySource other) {
  std::vector<std::string> words;
  const std::string choice = ". Opal uses " + used.name;
  if (used.odom_frame != other.odom_frame || used.base_frame != other.base_frame)
    words.push_back("odometry in different frames: " + frames_of(used) + ", " + frames_of(other) + choice);
  put_in_order(used.T_odom_base);
  put_in_order(other.T_odom_base);
  if (used.T_odom_base.empty() || other.T_odom_base.empty()) return words;
  const double begin_s = std::max(used.T_odom_base.front().stamp_s, other.T_odom_base.front().stamp_s);
  const double end_s = std::min(used.T_odom_base.back().stamp_s, other.T_odom_base.back().stamp_s);
  if (end_s - begin_s < kStep_s) {
    words.push_back("odometry at different times: " + used.name + " and " + other.name +
                    " have no second in common by their stamps" + choice);
    return words;
  }
  const Motion one = motion_of(used, begin_s, end_s), two = motion_of(other, begin_s, end_s);
  if (differs(one.driven_m, two.driven_m, kEnough_m) || differs(one.turned_rad, two.turned_rad, kEnough_rad))
    words.push_back("odometry differs by more than 5 %: " + words_of(used, one) + ", " + words_of(other, two) +
                    fmt::format(" in the same {:.1f} s", end_s - begin_s) + choice);
  else if (std::max(one.driven_m, two.driven_m) <= kEnough_m && std::max(one.turned_rad, two.turned_rad) <= kEnough_rad)
    words.push_back("odometry comes from " + used.name + " and from " + other.name +
                    ", and the robot hardly moved: drive it during the check to see whether both agree" + choice);
  return words;
}

}  // namespace opal::ros2
