#include "local_map/laser_odometry.hpp"

#include "common/covariance.hpp"
#include "local_map/matched_points.hpp"
#include "sensing/standstill.hpp"

#include <cmath>
#include <utility>

namespace opal {
namespace {

// So long after the wheels have stopped counting it is noticed at the latest, in a corridor of which few beams change.
constexpr double kLongest_s = 4;
// What a motion that goes on as it was is wrong by, from scan to scan.
constexpr double kSigma_m = 0.1, kSigma_rad = 0.15;
// Scans farther apart see too little of the same.
constexpr double kApart_m = 0.25, kApart_rad = 0.25;
// Scans that tell of a motion lie over each other, and not as well beside it.
constexpr double kFewestInliers = 0.5, kLargestSigma_m = 0.1;
constexpr double kShortest_s = 0.01;
// While something hides what was seen just before, the motion goes on as it was, for so long.
constexpr double kCoasts_s = 0.6;

bool tells(const ScanMatch& match) {
  return match.converged && match.inlier_share >= kFewestInliers && match.covariance.allFinite() &&
         largest_sigma(match.covariance.topLeftCorner<2, 2>()) < kLargestSigma_m;
}

Eigen::Vector3d speed_of(const Pose2& motion, double duration_s) {
  const Eigen::Vector3d step(motion.position().x(), motion.position().y(), motion.heading_rad());
  return duration_s < kShortest_s ? Eigen::Vector3d::Zero().eval() : (step / duration_s).eval();
}

Pose2 motion_at(const Eigen::Vector3d& speed, double duration_s) {
  const Eigen::Vector3d step = speed * duration_s;
  return {Point(step.head<2>()), step.z()};
}

}  // namespace

void LaserOdometry::add(const Sample& sample, bool is_frozen) {
  if (!is_frozen) is_sure_ = true;
  Seen seen{sample.stamp_s, points_in_base(sample)};
  const bool stands = T_odom_wheels_ && kNothingCounted.holds(*T_odom_wheels_, sample.T_odom_base);
  if (!stands) {
    take_wheels(sample);
    return take_for_reference(std::move(seen));
  }
  wait(std::move(seen));
  if (!is_frozen) return;
  is_sure_ = is_sure_ && matcher_;
  for (; !waiting_.empty() && is_sure_; waiting_.pop_front()) follow(std::move(waiting_.front()));
}

void LaserOdometry::take_wheels(const Sample& sample) {
  speed_ = T_odom_wheels_ ? speed_of(T_odom_wheels_->inverse() * sample.T_odom_base, sample.stamp_s - stamp_s_)
                          : Eigen::Vector3d::Zero();
  T_odom_wheels_ = sample.T_odom_base;
  waiting_.clear();
  has_forgotten_ = false;
  coasted_s_ = 0;
}

/// A robot of which nothing is noticed for so long stands.
void LaserOdometry::wait(Seen seen) {
  waiting_.push_back(std::move(seen));
  if (waiting_.back().stamp_s - waiting_.front().stamp_s <= kLongest_s) return;
  take_for_reference(std::move(waiting_.front()));
  waiting_.pop_front();
  speed_.setZero();
  has_forgotten_ = true;
}

ScanMatch LaserOdometry::laid_over_reference(const Seen& seen) const {
  const Pose2 guess = T_reference_base_ * motion_at(speed_, seen.stamp_s - stamp_s_);
  return matcher_->match(reference_.points, seen.points, guess, {kSigma_m, kSigma_m, kSigma_rad});
}

/// A motion that begins or ends between two scans is found from the scan just before.
ScanMatch LaserOdometry::laid_over_either(const Seen& seen) {
  const ScanMatch match = laid_over_reference(seen);
  if (tells(match) || !previous_) return match;
  take_for_reference(*std::exchange(previous_, std::nullopt));
  return laid_over_reference(seen);
}

void LaserOdometry::follow(Seen seen) {
  const double duration_s = seen.stamp_s - stamp_s_;
  const ScanMatch match = laid_over_either(seen);
  const Pose2 T_reference_before = T_reference_base_;
  if (tells(match)) {
    const bool stood = !std::exchange(has_forgotten_, false) || is_standstill(match.T_reference_scan);
    is_sure_ = is_sure_ && stood;
    coasted_s_ = 0;
    T_reference_base_ = match.T_reference_scan;
    speed_ = speed_of(T_reference_before.inverse() * T_reference_base_, duration_s);
  } else {
    coasted_s_ += duration_s;
    is_sure_ = is_sure_ && coasted_s_ < kCoasts_s;
    T_reference_base_ = T_reference_before * motion_at(speed_, duration_s);
  }
  T_odom_counted_ = T_odom_reference_ * *T_odom_wheels_ * T_reference_base_ * T_odom_wheels_->inverse();
  stamp_s_ = seen.stamp_s;
  if (T_reference_base_.position().norm() > kApart_m || std::abs(T_reference_base_.heading_rad()) > kApart_rad)
    take_for_reference(std::move(seen));
  else
    previous_ = std::move(seen);
}

void LaserOdometry::take_for_reference(Seen seen) {
  stamp_s_ = seen.stamp_s;
  reference_ = std::move(seen);
  previous_.reset();
  T_odom_reference_ = T_odom_counted_;
  T_reference_base_ = {};
}

void LaserOdometry::begin_at_newest() {
  if (waiting_.empty()) return;
  take_for_reference(std::move(waiting_.back()));
  waiting_.clear();
}

void LaserOdometry::clear() { *this = LaserOdometry(std::move(matcher_)); }

}  // namespace opal
