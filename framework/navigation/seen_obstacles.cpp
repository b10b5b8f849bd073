#include "navigation/seen_obstacles.hpp"

#include <algorithm>

namespace opal::navigation {
namespace {

constexpr int kDirections = 720;

int direction_of(double bearing_rad) {
  if (std::abs(bearing_rad) > std::numbers::pi) bearing_rad = wrap_angle(bearing_rad);
  const int k = static_cast<int>((bearing_rad + std::numbers::pi) / (2 * std::numbers::pi) * kDirections);
  return std::clamp(k, 0, kDirections - 1);
}

}  // namespace

long SeenObstacles::key_of(const Point& p_odom, double cell_m) {
  const auto x = static_cast<long>(std::floor(p_odom.x() / cell_m));
  const auto y = static_cast<long>(std::floor(p_odom.y() / cell_m));
  return x * 4000037 + y;
}

void SeenObstacles::sweep(const Scan& scan) {
  if (!sweep_.ranges_m.empty()) earlier_.push_back(std::move(sweep_));
  while (earlier_.size() > 1 && now_s_ - earlier_[1].stamp_s >= memory_.earlier_s) earlier_.pop_front();
  sweep_ = {T_odom_laser_, now_s_, std::vector<double>(kDirections, 0)};
  for (const ScanPoint& point : scan.points) {
    double& range = sweep_.ranges_m[direction_of(point.bearing_rad)];
    range = range == 0 ? point.range_m : std::min(range, point.range_m);
  }
}

double SeenObstacles::Sweep::range_at(double bearing_rad, int slack) const {
  double least = 0;
  const int direction = direction_of(bearing_rad);
  for (int k = -slack; k <= slack; ++k) {
    const double range = ranges_m[(direction + k + kDirections) % kDirections];
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
  std::vector<Point> movers = moved(scan);
  leave_out_panes(movers);
  constexpr double kBeside_m = 0.5;
  for (const ScanPoint& point : scan.points) {
    const Point p = T_odom_laser_ * point.position;
    const bool moves = std::ranges::any_of(movers, [&](const Point& q) { return (p - q).norm() < kBeside_m; });
    see(p, moves ? Motion::moving : Motion::still);
  }
}

void SeenObstacles::see(const Point& p_odom, Motion motion) {
  constexpr double kNever_s = -1e9;
  const long key = key_of(p_odom, memory_.cell_m);
  const auto [entry, is_new] = point_of_.try_emplace(key, points_.size());
  if (is_new) points_.push_back({key, p_odom, now_s_, kNever_s, 1});
  SeenPoint& seen = points_[entry->second];
  if (seen.stamp_s != now_s_) ++seen.scans;
  seen.p_odom = p_odom;
  seen.stamp_s = now_s_;
  if (motion == Motion::moving) seen.moved_s = now_s_;
}

/// Points of a scan where beams passed not long ago, frame odom. A lone one is a thin leg that was missed before.
std::vector<Point> SeenObstacles::moved(const Scan& scan) const {
  constexpr double kPassed_m = 0.25, kReach_m = 3, kTogether_m = 0.15;
  constexpr long kLeast = 3;
  std::vector<Point> found;
  if (earlier_.empty()) return found;
  const Sweep& before = earlier_.front();
  const Pose2 T_before_now = before.T_odom_laser.inverse() * T_odom_laser_;
  for (const ScanPoint& point : scan.points) {
    if (point.range_m > kReach_m) continue;
    const Point p = T_before_now * point.position;
    if (before.range_at(std::atan2(p.y(), p.x()), 4) > p.norm() + kPassed_m)
      found.push_back(T_odom_laser_ * point.position);
  }
  std::vector<Point> together;
  for (const Point& p : found)
    if (std::ranges::count_if(found, [&](const Point& q) { return (p - q).norm() < kTogether_m; }) >= kLeast)
      together.push_back(p);
  return together;
}

/// Who walks comes into a cell and goes on; a pane sends back some beams of one scan and none of the next.
void SeenObstacles::leave_out_panes(std::vector<Point>& movers) {
  constexpr double kCell_m = 0.2, kAnew_s = 0.3;
  constexpr int kOften = 3;
  std::erase_if(arrivals_, [&](const auto& entry) { return now_s_ - entry.second.newest_s > memory_.flicker_s; });
  std::erase_if(movers, [&](const Point& p) {
    Arrivals& arrivals = arrivals_[key_of(p, kCell_m)];
    if (arrivals.count == 0 || now_s_ - arrivals.newest_s > kAnew_s) ++arrivals.count;
    arrivals.newest_s = now_s_;
    return arrivals.count > kOften;
  });
}

/// Points are forgotten when they are old, or a beam and its neighbours end clearly behind them.
void SeenObstacles::forget() {
  constexpr double kBehind_m = 0.2, kReach_m = 12;  // what is farther away concerns no plan yet
  const Pose2 T_laser_odom = T_odom_laser_.inverse();
  const auto is_gone = [&](const SeenPoint& seen) {
    const double age_s = now_s_ - seen.stamp_s;
    if (age_s > memory_.planning_s) return true;
    if (age_s <= memory_.newest_s) return false;
    const Point p = T_laser_odom * seen.p_odom;
    return p.squaredNorm() < kReach_m * kReach_m && sweep_.range_at(std::atan2(p.y(), p.x()), 2) > p.norm() + kBehind_m;
  };
  for (std::size_t k = points_.size(); k-- > 0;)
    if (is_gone(points_[k])) drop(k);
}

/// The last one takes its place.
void SeenObstacles::drop(std::size_t point) {
  point_of_.erase(points_[point].key);
  if (point + 1 < points_.size()) {
    points_[point] = points_.back();
    point_of_[points_[point].key] = point;
  }
  points_.pop_back();
}

std::vector<Obstacle> SeenObstacles::near(double reach_m) const {
  const Pose2 T_base_odom = T_odom_base_.inverse(), T_laser_odom = T_odom_laser_.inverse();
  std::vector<Obstacle> found;
  for (const SeenPoint& seen : points_) {
    const double age_s = now_s_ - seen.stamp_s;
    if (age_s > memory_.unseen_s) continue;
    const Point p = T_base_odom * seen.p_odom;
    if (p.squaredNorm() > reach_m * reach_m) continue;
    const Point in_laser = T_laser_odom * seen.p_odom;
    const bool looked_at = sweep_.range_at(std::atan2(in_laser.y(), in_laser.x()), 1) > 0;
    if (age_s > memory_.newest_s && looked_at) continue;
    found.push_back({p, now_s_ - seen.moved_s < memory_.moving_s ? memory_.berth_m : 0});
  }
  return found;
}

template <class Test>
std::vector<Point> SeenObstacles::within(double reach_m, Test test) const {
  std::vector<Point> found;
  for (const SeenPoint& seen : points_)
    if (test(seen) && (seen.p_odom - T_odom_base_.position()).norm() <= reach_m) found.push_back(seen.p_odom);
  return found;
}

std::vector<Point> SeenObstacles::standing(double reach_m) const {
  return within(reach_m, [this](const SeenPoint& seen) { return seen.scans >= memory_.scans && !waits(seen); });
}

std::vector<Point> SeenObstacles::moving(double reach_m) const {
  return within(reach_m, [this](const SeenPoint& seen) {
    const bool has_gone = now_s_ - seen.stamp_s > memory_.unseen_s;
    return waits(seen) && !has_gone;
  });
}

}  // namespace opal::navigation
