#include "sensing/trajectory.hpp"

#include <algorithm>
#include <charconv>
#include <ostream>

namespace opal {
namespace {

// Nanoseconds of today's clocks, in so far as a double has them; micrometres.
constexpr int kDecimals = 9;

/// Always with a point, whatever the locale says.
void append(std::string& line, double number) {
  char digits[400];  // the largest double has 309 before its point
  const auto end = std::to_chars(digits, digits + sizeof digits, number, std::chars_format::fixed, kDecimals).ptr;
  line.append(digits, end);
}

void append_all(std::string& line, char separator, std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    if (!line.empty()) line += separator;
    append(line, number);
  }
}

bool is_finite(double stamp_s, const Pose2& pose) {
  return std::isfinite(stamp_s) && pose.position().allFinite() && std::isfinite(pose.heading_rad());
}

}  // namespace

void write_tum(std::ostream& out, std::span<const StampedPose> trajectory) {
  for (const auto& [stamp_s, pose] : trajectory) {
    if (!is_finite(stamp_s, pose)) continue;
    const double half_rad = pose.heading_rad() / 2;
    std::string line;
    append_all(line, ' ', {stamp_s, pose.x(), pose.y(), 0, 0, 0, std::sin(half_rad), std::cos(half_rad)});
    out << line << '\n';
  }
}

std::optional<Pose2> pose_at(std::span<const StampedPose> poses, double stamp_s) {
  const auto after = std::ranges::lower_bound(poses, stamp_s, {}, &StampedPose::stamp_s);
  if (after == poses.end()) return std::nullopt;
  if (after->stamp_s == stamp_s) return after->pose;
  if (after == poses.begin()) return std::nullopt;
  const StampedPose &a = *(after - 1), &b = *after;
  const double share = (stamp_s - a.stamp_s) / (b.stamp_s - a.stamp_s);
  const double turn_rad = wrap_angle(b.pose.heading_rad() - a.pose.heading_rad());
  return Pose2(Point(a.pose.position() + share * (b.pose.position() - a.pose.position())),
               a.pose.heading_rad() + share * turn_rad);
}

}  // namespace opal
