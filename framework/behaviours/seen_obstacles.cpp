#include "behaviours/seen_obstacles.hpp"

#include <algorithm>

namespace opal::behaviours {
namespace {

constexpr int kDirections = 720;

int direction_of(double bearing_rad) {
  const int k = static_cast<int>((wrap_angle(bearing_rad) + std::numbers::pi) / (2 * std::numbers::pi) * kDirections);
  return std::clamp(k, 0, kDirections - 1);
}

}  // namespace

long SeenObstacles::key_of(const Point& p_odom) const {
  const auto x = static_cast<long>(std::floor(p_odom.x() / memory_.cell_m));
  const auto y = static_cast<long>(std::floor(p_odom.y() / memory_.cell_m));
  return x * 4000037 + y;
}

void SeenObstacles::sweep(const Scan& scan) {
  sweep_.ranges_m.assign(kDirections, 0);
  for (const ScanPoint& point : scan.points) {
    double& range = sweep_.ranges_m[direction_of(point.bearing_rad)];
    range = range == 0 ? point.range_m : std::min(range, point.range_m);
  }
}

double SeenObstacles::Sweep::range_at(double bearing_rad, int slack) const {
  double least = 0;
  for (int k = -slack; k <= slack; ++k) {
    const double range = ranges_m[(direction_of(bearing_rad) + k + kDirections) % kDirections];
    if (range > 0) least = least == 0 ? range : std::min(least, range);
  }
  return least;
}

void SeenObstacles::add(const Scan& scan, const Pose2& T_odom_base, const Pose2& T_base_laser) {
  now_s_ = scan.stamp_s;
  T_odom_base_ = T_odom_base;
  T_odom_laser_ = T_odom_base * T_base_laser;
  sweep(scan);
  forget();
  for (const ScanPoint& point : scan.points) {
    const Point p = T_odom_laser_ * point.position;
    points_[key_of(p)] = {p, now_s_};
  }
}

/// Points are forgotten when they are old, or a beam and its neighbours end clearly behind them.
void SeenObstacles::forget() {
  constexpr double kBehind_m = 0.2;
  const Pose2 T_laser_odom = T_odom_laser_.inverse();
  std::erase_if(points_, [&](const auto& entry) {
    const double age_s = now_s_ - entry.second.stamp_s;
    if (age_s > memory_.planning_s) return true;
    if (age_s <= memory_.newest_s) return false;
    const Point p = T_laser_odom * entry.second.p_odom;
    return sweep_.range_at(std::atan2(p.y(), p.x()), 2) > p.norm() + kBehind_m;
  });
}

std::vector<Point> SeenObstacles::near(double reach_m) const {
  const Pose2 T_base_odom = T_odom_base_.inverse(), T_laser_odom = T_odom_laser_.inverse();
  std::vector<Point> found;
  for (const auto& [key, seen] : points_) {
    const double age_s = now_s_ - seen.stamp_s;
    if (age_s > memory_.unseen_s) continue;
    const Point p = T_base_odom * seen.p_odom;
    if (p.squaredNorm() > reach_m * reach_m) continue;
    const Point in_laser = T_laser_odom * seen.p_odom;
    const bool looked_at = sweep_.range_at(std::atan2(in_laser.y(), in_laser.x()), 1) > 0;
    if (age_s <= memory_.newest_s || !looked_at) found.push_back(p);
  }
  return found;
}

std::vector<Point> SeenObstacles::lately(double reach_m) const {
  std::vector<Point> found;
  for (const auto& [key, seen] : points_)
    if ((seen.p_odom - T_odom_base_.position()).norm() <= reach_m) found.push_back(seen.p_odom);
  return found;
}

}  // namespace opal::behaviours
