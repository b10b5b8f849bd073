#include "sensor_health/motion_pairs.hpp"

#include "sensing/standstill.hpp"

namespace opal {
namespace {

// A motion is long enough to tell its direction, and short enough that the scans are alike.
constexpr double kStep_m = 0.25, kStep_rad = 0.25, kTooFar_m = 1, kTooFar_rad = 0.8;
/// A robot that stands by its odometry is looked at this often: it may be driving all the same.
constexpr double kStanding_s = 0.5;
constexpr double kFewestInliers = 0.6, kStillInliers = 0.3, kPlainInliers = 0.85, kClearlyMore = 0.2;
constexpr std::size_t kFewestPoints = 20;
/// A distance of which scans may tell whether it was driven forwards or backwards, and how many more of the points
/// agree with the one than with the other if they do.
constexpr double kTellsDirection_m = 0.1, kMoreInliers = 0.03;
constexpr double kUnknown = 100;  // square of how much longer the motion may as well have been, if nothing tells

std::vector<Point> positions_of(const Scan& scan) {
  std::vector<Point> points;
  points.reserve(scan.points.size());
  for (const ScanPoint& point : scan.points) points.push_back(point.position);
  return points;
}

double fit_of(const ScanMatch& match) { return match.converged ? match.inlier_share : 0; }

}  // namespace

void MotionPairs::clear() {
  begun_ = false;
  skipped_ = 0;
}

void MotionPairs::begin_at(const Scan& scan, const Pose2& T_odom_base) {
  reference_ = positions_of(scan);
  T_odom_reference_ = T_odom_base;
  reference_stamp_s_ = scan.stamp_s;
  begun_ = true;
}

ScanMatch MotionPairs::near(const std::vector<Point>& points, const Pose2& T_laser) const {
  const double sigma_m = 0.03 + 0.1 * T_laser.position().norm(),
               sigma_rad = 0.03 + 0.1 * std::abs(T_laser.heading_rad());
  return matcher_->match(reference_, points, T_laser, {sigma_m, sigma_m, sigma_rad});
}

/// The search is as wide backwards as forwards, and reaches twice as far as odometry moved.
ScanMatch MotionPairs::any_way(const std::vector<Point>& points, const Pose2& T_odometry) const {
  const double sigma_m = 0.15 + T_odometry.position().norm() / 1.5;
  const double sigma_rad = 0.08 + std::abs(T_odometry.heading_rad()) / 1.5;
  return matcher_->match(reference_, points, Pose2(), {sigma_m, sigma_m, sigma_rad});
}

std::optional<MotionPair> MotionPairs::laid_over(const std::vector<Point>& points, const Pose2& T_odometry) const {
  const Pose2 T_described = T_base_laser_.inverse() * T_odometry * T_base_laser_;
  ScanMatch match = near(points, T_described);
  const bool stands = is_standstill(T_odometry);
  bool is_as_described = true, is_still = false;
  if (stands || fit_of(match) < kPlainInliers) {
    const ScanMatch free = any_way(points, T_odometry);
    is_still =
        stands && free.converged && is_standstill(match.T_reference_scan) && is_standstill(free.T_reference_scan);
    is_as_described = fit_of(free) <= fit_of(match) + (stands ? kMoreInliers : kClearlyMore);
    if (!is_as_described) match = free;
  }
  if (is_as_described && T_odometry.position().norm() > kTellsDirection_m)
    is_as_described = !prefer_backwards(points, T_described, match);
  // People hide most of what a robot sees that stands in a crowd. A search for any motion that finds none is not
  // chance.
  const double fewest = is_still ? kStillInliers : kFewestInliers;
  if (!match.converged || match.inlier_share < fewest || !match.covariance.allFinite()) return std::nullopt;
  return MotionPair{T_odometry, match.T_reference_scan, match.covariance, is_as_described};
}

/// Between walls that run along the way, scans lie over each other either way, but for a few points.
bool MotionPairs::prefer_backwards(const std::vector<Point>& points, const Pose2& T_described, ScanMatch& match) const {
  const ScanMatch back = near(points, {Point(-T_described.position()), T_described.heading_rad()});
  if (back.converged && distance_m(back.T_reference_scan, match.T_reference_scan) < T_described.position().norm())
    return false;  // both ways lead to one place
  const double more = fit_of(back) - fit_of(match);
  if (more > kMoreInliers) {
    match = back;
    return true;
  }
  if (more >= -kMoreInliers)  // how far the laser moved along the way, nothing tells
    match.covariance.topLeftCorner<2, 2>() += kUnknown * T_described.position() * T_described.position().transpose();
  return false;
}

std::optional<MotionPair> MotionPairs::add(const Scan& scan, const Pose2& T_odom_base) {
  if (scan.points.size() < kFewestPoints) return std::nullopt;
  if (!begun_) {
    begin_at(scan, T_odom_base);
    return std::nullopt;
  }
  const Pose2 T_odometry = T_odom_reference_.inverse() * T_odom_base;
  const double moved_m = T_odometry.position().norm(), turned_rad = std::abs(T_odometry.heading_rad());
  const bool is_over =
      moved_m >= kStep_m || turned_rad >= kStep_rad || scan.stamp_s - reference_stamp_s_ >= kStanding_s;
  if (!is_over) return std::nullopt;
  std::optional<MotionPair> pair;
  if (skipped_ > 0 && !is_standstill(T_odometry))
    --skipped_;
  else if (moved_m <= kTooFar_m && turned_rad <= kTooFar_rad)
    pair = laid_over(positions_of(scan), T_odometry);
  begin_at(scan, T_odom_base);
  return pair;
}

}  // namespace opal
