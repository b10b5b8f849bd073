#pragma once

#include "learning/unmapped_faces.hpp"

#include <set>
#include <span>
#include <vector>

namespace opal {

/// A face as one keyframe shows it; frame: `map`.
struct FaceView {
  Segment part;  ///< beside which nothing is mapped
  std::size_t keyframe = 0;
  const SeenFace* seen = nullptr;
};

/// Views of one straight face, from wherever they show a part of it.
struct FaceViews {
  Segment extent;  ///< of all views, along the first one
  std::vector<FaceView> views = {};
  std::set<std::size_t> keyframes = {};

  const Segment& longest() const;
};

/// Sorts what keyframes see where the map has no surface with the same visible side, where it is believed to be, within
/// 0.25 m. Parts of at least 0.4 m count.
/// @param views  of the keyframes; must outlive the result. @param T_map_base  of each of them.
std::vector<FaceViews> views_of_unmapped_faces(const MapView& map, const MapBelief& belief,
                                               std::span<const KeyframeView> views, std::span<const Pose2> T_map_base);

}  // namespace opal
