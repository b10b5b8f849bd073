#include "navigation/path_drive.hpp"

#include "navigation/path.hpp"

#include <algorithm>

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

void PathDrive::drive(Situation& situation) {
  constexpr double kLookAhead_m = 2;
  const PlaceOnPath here = nearest_on_path(path_, situation.T_odom_base().position(), passed_, kLookAhead_m);
  passed_ = here.piece;
  std::vector<Point> left{here.position};
  left.insert(left.end(), path_.begin() + static_cast<std::ptrdiff_t>(std::min(here.piece + 1, path_.size() - 1)), path_.end());
  situation.drive_along(left);
}

}  // namespace opal::behaviours
