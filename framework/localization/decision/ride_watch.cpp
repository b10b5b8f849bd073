#include "localization/decision/ride_watch.hpp"

namespace opal {
namespace {

// Less is noise of standing wheels.
constexpr double kStill_m = 0.03, kStill_rad = 0.03;
// A robot that stands for less has hardly come to rest.
constexpr double kAtRest_s = 0.5;
// A robot at the door's threshold is not in the cabin; poses are off by a few centimetres.
constexpr double kSlack_m = 0.1;

bool is_lift(const MapConnection& connection) {
  return connection.type == "opal:Lift" && connection.landings.size() > 1;
}

}  // namespace

RideWatch::RideWatch(const std::shared_ptr<const MapView>& map, const RideOptions& options) : options_(options) {
  for (const MapConnection& connection : map->map().origin().connections) {
    if (!is_lift(connection)) continue;
    Cabin cabin{connection.radius_m, {}};
    for (const Landing& landing : connection.landings)
      cabin.T_map_landing.push_back(landing_on_map(map->map(), landing));
    cabins_.push_back(std::move(cabin));
  }
}

bool RideWatch::may_have_ridden(const Sample& sample, const std::optional<Pose2>& best, bool sees_other) {
  if (cabins_.empty()) return false;
  const Pose2& now = sample.T_odom_base;
  const bool moved = !anchor_ || distance_m(anchor_->T_odom_base, now) > kStill_m ||
                     angle_between_rad(anchor_->T_odom_base, now) > kStill_rad;
  if (moved) anchor_ = Anchor{now, sample.stamp_s};
  const double stood_s = sample.stamp_s - anchor_->since_s;
  const bool is_due = stood_s >= options_.stand_s || (sees_other && stood_s >= kAtRest_s);
  if (anchor_->is_told || !is_due || !best || !is_in_lift(*best)) return false;
  anchor_->is_told = true;
  return true;
}

std::vector<Pose2> RideWatch::elsewhere(const Pose2& T_map_base) const {
  for (const Cabin& cabin : cabins_)
    for (std::size_t k = 0; k < cabin.T_map_landing.size(); ++k) {
      if (distance_m(cabin.T_map_landing[k], T_map_base) > cabin.radius_m + kSlack_m) continue;
      const Pose2 T_landing_base = cabin.T_map_landing[k].inverse() * T_map_base;
      std::vector<Pose2> poses;
      for (std::size_t other = 0; other < cabin.T_map_landing.size(); ++other)
        if (other != k) poses.push_back(cabin.T_map_landing[other] * T_landing_base);
      return poses;
    }
  return {};
}

}  // namespace opal
