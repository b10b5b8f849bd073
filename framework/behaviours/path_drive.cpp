#include "behaviours/path_drive.hpp"

namespace opal::behaviours {

FloorGrid::Surcharge unmapped_surcharge(const Situation& situation) {
  constexpr double kReach_m = 10, kMapped_m = 0.25, kBeside_m = 0.04;
  constexpr float kBeside = 25, kBlocked = 300;  // per metre: a detour of 100 m is better than to try what is blocked
  const Pose2 T_map_odom = situation.T_map_odom();
  std::vector<Point> all, unmapped;
  for (const Point& p : situation.obstacles().lately(kReach_m)) {
    all.push_back(T_map_odom * p);
    if (situation.localization.map().clearance_m(all.back()) > kMapped_m) unmapped.push_back(all.back());
  }
  for (const Point& p : situation.impasses()) unmapped.push_back(T_map_odom * p);
  const MotionOptions& motion = situation.motion.options();
  const double keep_m = motion.radius_m + motion.margin_m;
  FloorGrid::Surcharge prices = situation.floor.no_surcharge();
  situation.floor.raise(prices, unmapped, keep_m + kBeside_m, kBeside);
  situation.floor.raise(prices, unmapped, keep_m, kBlocked);
  situation.floor.raise(prices, all, motion.radius_m, kBlocked);
  return prices;
}

PathDrive::PathDrive(const Pose2& T_odom_map, const std::vector<Point>& path_map) {
  for (const Point& p : path_map) path_.push_back(T_odom_map * p);
}

bool PathDrive::arrived(const Situation& situation, double within_m) const {
  return path_.empty() || (path_.back() - situation.T_odom_base().position()).norm() < within_m;
}

/// The target is the last point that is near, or on the straight continuation: corners must not be cut.
void PathDrive::drive(Situation& situation) {
  constexpr double kAhead_m = 1.0, kOff_m = 0.12;
  const Point here = situation.T_odom_base().position();
  for (std::size_t k = next_; k < path_.size() && k < next_ + 20; ++k)
    if ((path_[k] - here).norm() < (path_[next_] - here).norm()) next_ = k;
  std::size_t target = std::min(next_ + 1, path_.size() - 1);
  for (std::size_t k = target + 1; k < path_.size() && (path_[k] - here).norm() < kAhead_m; ++k) {
    const Point way = (path_[k] - here).normalized();
    bool straight = true;
    for (std::size_t j = next_; j < k && straight; ++j) straight = std::abs(cross(way, path_[j] - here)) < kOff_m;
    if (straight || (path_[k] - here).norm() < 0.4) target = k;
  }
  situation.drive_towards(path_[target]);
}

}  // namespace opal::behaviours
