#include "ros2/messages/announcement.hpp"

#include <cmath>

namespace opal::ros2 {
namespace {

bool is_number(const Pose2& pose) { return pose.position().allFinite() && std::isfinite(pose.heading_rad()); }

std::vector<PossiblePlace> places_of(const PoseEstimate& estimate) {
  std::vector<PossiblePlace> places;
  const auto add = [&](const Pose2& T_map_base, double probability) {
    if (is_number(T_map_base) && std::isfinite(probability)) places.push_back({T_map_base, probability});
  };
  if (estimate.has_pose) add(estimate.T_map_base, estimate.probability);
  for (const PoseEstimate::Alternative& other : estimate.alternatives) add(other.T_map_base, other.probability);
  return places;
}

}  // namespace

Announcement announcement_of(const LiveAnswer& answer, const FrameOptions& frames) {
  const PoseEstimate& estimate = answer.estimate;
  Announcement announcement;
  announcement.stamp_s = answer.stamp_s;
  if (estimate.status == Status::searching || estimate.status == Status::ambiguous)
    announcement.places = places_of(estimate);
  const bool is_localized = estimate.status == Status::localized && estimate.has_pose &&
                            is_number(estimate.T_map_base) && is_number(answer.T_map_odom);
  if (!is_localized) return announcement;
  announcement.map_to_odom =
      PlacedFrame{answer.stamp_s + frames.transform_tolerance_s, frames.map, frames.odom, answer.T_map_odom};
  if (estimate.covariance.allFinite())
    announcement.pose = LocalizedPose{answer.stamp_s, estimate.T_map_base, estimate.covariance};
  return announcement;
}

}  // namespace opal::ros2
