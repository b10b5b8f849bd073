#pragma once

#include "learning/drive_legs.hpp"

namespace opal {

/// Faces that the map lacks, as landmarks of a graph: rooms with few mapped walls hang together by them.
struct Landmarks {
  std::vector<Segment> faces;                                        ///< where they are thought to be, frame `map`
  std::vector<std::vector<std::vector<LandmarkSight>>> sights = {};  ///< of each leg, of each keyframe
};

/// @param belief      what is known of the mapped features.
/// @param T_map_base  of each leg, of each keyframe.
/// @return those that three keyframes see at least.
Landmarks landmarks_of(const MapView& map, const MapBelief& belief, std::span<const DriveLeg> legs,
                       std::span<const std::vector<Pose2>> T_map_base);

}  // namespace opal
