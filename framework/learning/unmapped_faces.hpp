#pragma once

#include <opal/map/view/map_view.hpp>
#include "survey/map_belief.hpp"

#include <span>
#include <vector>

namespace opal {

/// A straight face that a drive has seen where the map has nothing. Frame: `map`; the visible side is on the left.
struct UnmappedFace {
  Segment face;
  int views = 0;                  ///< keyframes that saw it
  double seen_through_share = 0;  ///< of the keyframes that saw it or through it: through it, in [0, 1]
};

/// Where beams of one laser ended, by increasing bearing; frame of the robot.
struct LaserReturns {
  Point laser;
  std::vector<Point> points;
};

/// A straight piece of what one scan shows, the robot on its left; frame of the robot.
struct SeenFace {
  Segment segment;
  /// (offset at its midpoint, heading) [m, rad].
  Eigen::Matrix2d covariance = Eigen::Vector2d(0.02, 0.01).cwiseAbs2().asDiagonal();
};

/// What one keyframe saw, in the frame of the robot then.
struct KeyframeView {
  std::vector<SeenFace> faces;
  std::vector<std::pair<Point, Point>> beams;  ///< some of the beams: from the laser to where they ended
  std::vector<LaserReturns> returns;           ///< of each laser
};

/// Gathers the straight faces of a drive for which the map has no surface, where it is believed to be, within 0.25 m.
/// The other side of a mapped wall is another face.
/// @param views       of the keyframes. @param T_map_base  of each of them.
/// @param belief      what the drive says of the mapped features.
/// @return longer than 0.8 m and seen from 3 keyframes at least, by place.
std::vector<UnmappedFace> unmapped_faces(const MapView& map, const MapBelief& belief,
                                         std::span<const KeyframeView> views, std::span<const Pose2> T_map_base);

}  // namespace opal
