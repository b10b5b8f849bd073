#include "navigation/path_drive.hpp"

#include "navigation/path.hpp"

#include <algorithm>

namespace opal::navigation {

namespace {

std::vector<Point> in_map(const Pose2& T_map_odom, std::vector<Point> points_odom) {
  for (Point& p : points_odom) p = T_map_odom * p;
  return points_odom;
}

}  // namespace

FloorGrid::Surcharge unmapped_surcharge(const Blackboard& blackboard) {
  constexpr double kReach_m = 10, kBeside_m = 0.06, kWheelTrack_m = 0.1;
  constexpr double kSteering_m = 0.02;  // noise of ranges and steering: a gap that just fits is tried again and again
  // Per metre. Any way round is better than what is blocked. Who walks will have gone on until the robot is there.
  constexpr float kBeside = 25, kBlocked = 2000;
  const Pose2 T_map_odom = blackboard.T_map_odom();
  const std::vector<Point> standing = in_map(T_map_odom, blackboard.obstacles().standing(kReach_m)),
                           moving = in_map(T_map_odom, blackboard.obstacles().moving(kReach_m));
  const MotionOptions& motion = blackboard.motion.options();
  const double keep_m = motion.radius_m + motion.margin_m;
  FloorGrid::Surcharge prices = blackboard.tight;
  blackboard.floor.raise(prices, moving, keep_m + kBeside_m, kBeside);
  const auto bar = [&](const std::vector<Point>& points) {
    blackboard.floor.raise(prices, points, keep_m + kBeside_m, kBeside);
    blackboard.floor.raise(prices, points, keep_m + kSteering_m, kBlocked);
  };
  bar(blackboard.unmapped());
  blackboard.floor.raise(prices, standing, motion.radius_m, kBlocked);
  blackboard.floor.limit(prices, blackboard.passed(), kWheelTrack_m, kBeside);
  bar(blackboard.impasses());
  return prices;
}

PathDrive::PathDrive(const Pose2& T_odom_map, const std::vector<Point>& path_map) {
  for (const Point& p : path_map) path_.push_back(T_odom_map * p);
}

bool PathDrive::arrived(const Blackboard& blackboard, double within_m) const {
  return path_.empty() || (path_.back() - blackboard.T_odom_base().position()).norm() < within_m;
}

void PathDrive::drive(Blackboard& blackboard) {
  constexpr double kLookAhead_m = 2;
  const PlaceOnPath here = nearest_on_path(path_, blackboard.T_odom_base().position(), passed_, kLookAhead_m);
  passed_ = here.piece;
  std::vector<Point> left{here.position};
  left.insert(left.end(), path_.begin() + static_cast<std::ptrdiff_t>(std::min(here.piece + 1, path_.size() - 1)),
              path_.end());
  blackboard.drive_along(left);
}

}  // namespace opal::navigation
