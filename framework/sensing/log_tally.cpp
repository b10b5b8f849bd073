#include "sensing/log_tally.hpp"

#include <opal/common/quantile.hpp>

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

constexpr double kGapIntervals = 5;
constexpr double kGap_s = 0.5;
// Of all readings: real ranges that agree to the last bit are rarer, and a value that stands for "nothing" is not.
constexpr double kSameFarthestShare = 0.005;

}  // namespace

void StampTally::tell(LogTopic& topic) const {
  topic.messages = static_cast<std::int64_t>(stamps_s_.size());
  if (stamps_s_.empty()) return;
  std::vector<double> stamps_s = stamps_s_;
  std::sort(stamps_s.begin(), stamps_s.end());
  topic.first_s = stamps_s.front();
  topic.last_s = stamps_s.back();
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < stamps_s.size(); ++i) intervals_s.push_back(stamps_s[i] - stamps_s[i - 1]);
  topic.interval_s = median_of(intervals_s).value_or(0);
  for (std::size_t i = 0; i < intervals_s.size(); ++i) {
    if (intervals_s[i] > std::max(kGap_s, kGapIntervals * topic.interval_s)) ++topic.gaps;
    if (intervals_s[i] <= topic.longest_gap_s) continue;
    topic.longest_gap_s = intervals_s[i];
    topic.longest_gap_at_s = stamps_s[i];
  }
}

void LaserTally::add_range(float range_m) {
  ++readings_;
  if (std::isnan(range_m) || range_m <= 0) {
    ++invalid_;
  } else if (std::isinf(range_m)) {
    ++no_returns_;
  } else {
    if (nearest_m_ == 0 || range_m < nearest_m_) nearest_m_ = range_m;
    if (range_m == farthest_m_) ++at_farthest_;
    if (range_m < farthest_m_) second_farthest_m_ = std::max(second_farthest_m_, range_m);
    if (range_m <= farthest_m_) return;
    second_farthest_m_ = farthest_m_;
    farthest_m_ = range_m;
    at_farthest_ = 1;
  }
}

void LaserTally::add(const RawScan& scan) {
  if (!first_) first_ = scan;
  ++scans_by_beams_[static_cast<int>(scan.ranges_m.size())];
  for (const float range_m : scan.ranges_m) add_range(range_m);
}

void LaserTally::tell(LogLaser& laser) const {
  if (!first_) return;
  laser.frame = first_->frame;
  laser.angle_min_rad = first_->angle_min_rad;
  laser.angle_increment_rad = first_->angle_increment_rad;
  int most = 0;
  laser.scans = 0;
  for (const auto& [beams, scans] : scans_by_beams_) {
    laser.scans += scans;
    if (scans > most) laser.beams = beams;
    most = std::max(most, scans);
  }
  laser.other_scans = laser.scans - most;
  const bool stands_for_none = at_farthest_ > kSameFarthestShare * readings_ && second_farthest_m_ > 0;
  laser.no_return_m = stands_for_none ? farthest_m_ : 0;
  laser.nearest_m = nearest_m_;
  laser.farthest_m = stands_for_none ? second_farthest_m_ : farthest_m_;
  if (readings_ == 0) return;
  laser.no_return_share = (no_returns_ + (stands_for_none ? at_farthest_ : 0)) / readings_;
  laser.invalid_share = invalid_ / readings_;
}

void OdometryTally::add(const Pose2& T_odom_base) {
  ++poses_;
  if (last_) {
    const Pose2 motion = last_->inverse() * T_odom_base;
    driven_m_ += motion.position().norm();
    turned_rad_ += std::abs(motion.heading_rad());
  }
  last_ = T_odom_base;
}

void OdometryTally::tell(LogOdometry& odometry) const {
  odometry.poses = poses_;
  odometry.driven_m = driven_m_;
  odometry.turned_rad = turned_rad_;
}

}  // namespace opal
