#include "sensing/deskew.hpp"

#include "sensing/beam_order.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace opal {
namespace {

constexpr double kKnot_s = 0.01;  // odometry comes at 10 to 100 Hz; between two knots the motion is even
constexpr int kMostKnots = 64;
constexpr double kStands_m = 1e-6, kStands_rad = 1e-6;

/// The laser's motion during a sweep, from its place at the scan's stamp.
class LaserMotion {
 public:
  LaserMotion(const Sweep& sweep, const Pose2& T_base_laser, const MotionInSweep& T_fixed_base)
      : duration_s_(sweep.duration_s()) {
    const int steps = std::clamp(static_cast<int>(std::ceil(duration_s_ / kKnot_s)), 1, kMostKnots);
    const auto start = T_fixed_base(0), end = T_fixed_base(duration_s_);
    if (!start || !end) return;
    for (int k = 0; k <= steps; ++k) {
      const Pose2 now = T_fixed_base(duration_s_ * k / steps).value_or(*end);
      knots_.push_back(T_base_laser.inverse() * start->inverse() * now * T_base_laser);
    }
  }

  bool stands() const {
    return std::all_of(knots_.begin(), knots_.end(), [](const Pose2& knot) {
      return knot.position().norm() < kStands_m && std::abs(knot.heading_rad()) < kStands_rad;
    });
  }

  /// T_start_now
  Pose2 at(double time_s) const {
    const double position = std::clamp(time_s / duration_s_, 0.0, 1.0) * static_cast<double>(knots_.size() - 1);
    const std::size_t before = std::min(static_cast<std::size_t>(position), knots_.size() - 2);
    return interpolated(knots_[before], knots_[before + 1], position - static_cast<double>(before));
  }

 private:
  double duration_s_;
  std::vector<Pose2> knots_;
};

}  // namespace

double Sweep::time_of(double bearing_rad) const {
  constexpr double kRound = 2 * std::numbers::pi;
  const double sense = angle_increment_rad < 0 ? -1 : 1;
  // Half a beam before the first one counts as the first one.
  const double slack_rad = 0.5 * std::abs(angle_increment_rad);
  double along_rad = std::fmod(sense * (bearing_rad - angle_min_rad) + slack_rad, kRound);
  if (along_rad < 0) along_rad += kRound;
  const double beam =
      std::min(std::max(0.0, along_rad - slack_rad) / std::abs(angle_increment_rad), static_cast<double>(beams - 1));
  return times_s.empty() ? beam_s * beam : time_of_beam(static_cast<int>(std::lround(beam)));
}

Sweep sweep_of(const RawScan& raw, const LaserModel& laser) {
  const bool of_log = laser.geometry_from_log && raw.angle_min_rad && raw.angle_increment_rad;
  Sweep sweep{of_log ? *raw.angle_min_rad : laser.angle_min_rad,
              of_log ? *raw.angle_increment_rad : laser.angle_increment_rad, static_cast<int>(raw.ranges_m.size()), 0};
  if (sweep.angle_increment_rad == 0 || sweep.beams < 2) return sweep;
  if (laser.sweep_s || raw.beam_times_s.size() != raw.ranges_m.size()) {
    sweep.beam_s = laser.sweep_s ? *laser.sweep_s / (sweep.beams - 1) : std::max(0.0, raw.time_increment_s);
    return sweep;
  }
  sweep.times_s = raw.beam_times_s;
  sweep.last_s = *std::max_element(sweep.times_s.begin(), sweep.times_s.end());
  return sweep;
}

bool is_possible_sweep(double sweep_s, double interval_s) {
  constexpr double kLongest_s = 1;
  constexpr double kMostIntervals = 1.5;  // a sweep ends before the next one begins; stamps jitter
  return sweep_s <= kLongest_s && (interval_s <= 0 || sweep_s <= kMostIntervals * interval_s);
}

bool drop_impossible_times(Sweep& sweep, const LaserModel& laser, double interval_s) {
  if (laser.sweep_s || !sweep.times_s.empty() || is_possible_sweep(sweep.duration_s(), interval_s)) return false;
  sweep.beam_s = 0;
  return true;
}

void deskew(Scan& scan, const Sweep& sweep, const Pose2& T_base_laser, const MotionInSweep& T_fixed_base) {
  if (!sweep.takes_time()) return;
  const LaserMotion motion(sweep, T_base_laser, T_fixed_base);
  if (motion.stands()) return;
  for (ScanPoint& point : scan.points) {
    point.position = motion.at(sweep.time_of_beam(point.beam)) * point.position;
    point.range_m = point.position.norm();
    point.bearing_rad = wrap_angle(std::atan2(point.position.y(), point.position.x()));
  }
  for (double& bearing_rad : scan.free_bearings_rad)
    bearing_rad = wrap_angle(bearing_rad + motion.at(sweep.time_of(bearing_rad)).heading_rad());
  sort_by_bearing(scan);
}

}  // namespace opal
