#include "viewer/truth_track.hpp"

#include <algorithm>

namespace opal {

std::optional<Pose2> TruthTrack::at(double stamp_s) const {
  const auto after = std::lower_bound(poses_.begin(), poses_.end(), stamp_s,
                                      [](const StampedPose& p, double t) { return p.stamp_s < t; });
  if (after == poses_.end()) return std::nullopt;
  if (after->stamp_s == stamp_s) return after->pose;
  if (after == poses_.begin()) return std::nullopt;
  const StampedPose &a = *(after - 1), &b = *after;
  const double share = (stamp_s - a.stamp_s) / (b.stamp_s - a.stamp_s);
  const double turn = wrap_angle(b.pose.heading_rad() - a.pose.heading_rad());
  return Pose2(Point(a.pose.position() + share * (b.pose.position() - a.pose.position())),
               a.pose.heading_rad() + share * turn);
}

}  // namespace opal
