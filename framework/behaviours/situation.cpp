#include "behaviours/situation.hpp"

#include <opal/error.hpp>

namespace opal::behaviours {

FloorGrid mapped_floor(const MapView& map, double radius_m) {
  FloorGrid floor = seen_floor(map.map(), [&](const Point& p) { return map.clearance_m(p) > radius_m; });
  if (floor.cells().empty())
    throw MapError(map.map().name() + ": has no floor for a robot of " + std::to_string(radius_m) + " m radius");
  return floor;
}

void Situation::look() {
  before_ = velocity_;
  estimate_ = localization.estimate();
  obstacles_.add(localization.newest_scan(), T_odom_base(), localization.laser().T_base_laser);
  near_ = obstacles_.near(motion.reach_m());
  notice_progress();
  velocity_ = {};
}

void Situation::notice_progress() {
  constexpr double kSpacing_m = 0.3, kProgress_m = 0.2;
  const Point& here = T_odom_base().position();
  if (trail_.empty() || (trail_.back() - here).norm() > kSpacing_m) trail_.push_back(here);
  if (!driving_ || (here - moved_from_).norm() > kProgress_m) {
    moved_from_ = here;
    moved_at_s_ = now_s();
  }
  driving_ = false;
}

bool Situation::drive_towards(const Point& target_odom) {
  driving_ = true;
  const auto velocity = motion.towards(T_odom_base().inverse() * target_odom, near_, before_);
  velocity_ = velocity.value_or(Velocity{});
  return velocity.has_value();
}

bool Situation::drive_back() {
  const auto velocity = motion.backwards(near_);
  velocity_ = velocity.value_or(Velocity{});
  return velocity.has_value();
}

double Situation::room_m(double bearing_rad, double most_m) const {
  std::vector<Point> around;
  const Pose2 T_base_odom = T_odom_base().inverse();
  for (const Point& p : obstacles_.lately(most_m + 1)) around.push_back(T_base_odom * p);
  return motion.room_m(bearing_rad, around, most_m);
}

}  // namespace opal::behaviours
