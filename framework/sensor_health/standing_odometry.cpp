#include "sensor_health/standing_odometry.hpp"

#include "sensing/standstill.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace opal {
namespace {

constexpr double kLooksAfter_s = 1;  // people who pass have gone
constexpr double kChanged_m = 0.1;
constexpr double kMostChanged = 0.35;  // a crowd about a robot that stands changes fewer
constexpr std::size_t kFewestBeams = 20;

bool is_same_range(double a_m, double b_m) {
  const bool both_none = !std::isfinite(a_m) && !std::isfinite(b_m);
  return both_none || std::abs(a_m - b_m) < kChanged_m;
}

}  // namespace

StandingOdometry::View StandingOdometry::view_of(const Scan& scan) {
  View view{scan.stamp_s, {}};
  for (const ScanPoint& point : scan.points) {
    const auto beam = static_cast<std::size_t>(std::max(0, point.beam));
    if (view.ranges_m.size() <= beam) view.ranges_m.resize(beam + 1, std::numeric_limits<double>::infinity());
    view.ranges_m[beam] = point.range_m;
  }
  return view;
}

double StandingOdometry::share_changed(const View& before, const View& now) {
  const std::size_t beams = std::min(before.ranges_m.size(), now.ranges_m.size());
  if (beams < kFewestBeams) return 0;
  std::size_t changed = 0;
  for (std::size_t k = 0; k < beams; ++k) changed += is_same_range(before.ranges_m[k], now.ranges_m[k]) ? 0 : 1;
  return static_cast<double>(changed) / static_cast<double>(beams);
}

void StandingOdometry::add(const Scan& scan, const Pose2& T_odom_base) {
  const bool stands = T_odom_base_ && kNothingCounted.holds(*T_odom_base_, T_odom_base);
  if (!stands) {
    T_odom_base_ = T_odom_base;
    seen_.reset();
    changed_share_ = 0;
    return;
  }
  if (seen_ && scan.stamp_s >= seen_->stamp_s && scan.stamp_s - seen_->stamp_s < kLooksAfter_s) return;
  View now = view_of(scan);
  if (seen_ && scan.stamp_s > seen_->stamp_s) changed_share_ = share_changed(*seen_, now);
  seen_ = std::move(now);
}

bool StandingOdometry::is_frozen() const { return changed_share_ > kMostChanged; }

}  // namespace opal
