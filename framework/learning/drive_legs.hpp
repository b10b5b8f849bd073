#pragma once

#include "learning/unmapped_faces.hpp"
#include "survey/deviation_report.hpp"
#include "survey/tracking_graph.hpp"

#include <optional>
#include <vector>

namespace opal {

/// What one visit to a part of the building says: a stretch of one drive along which the robot was localized.
struct VisitEvidence {
  std::vector<Deviation> objects;      ///< what was recognized, or was looked for and seen through
  std::vector<UnmappedFace> unmapped;  ///< by place
};

/// A part of a drive that was followed without a break.
struct DriveLeg {
  std::vector<TrackedKeyframe> track;
  std::vector<KeyframeView> views;  ///< of each keyframe
  /// Keyframes of other legs that its first and last one are once more.
  std::optional<LegPlace> begins_at = std::nullopt, ends_at = std::nullopt;
  std::vector<std::size_t> visits = {};  ///< keyframes of each visit, one after the other
  /// Nobody followed the map along it. Its visits count only if scans fit the map where the legs around it put them.
  bool is_gap = false;
};

/// What the visits of a drive say, in the order of the legs. Poses and offsets of all legs are solved together; then
/// each visit says where it sees what is on the map from there.
/// @throws Error if the graph has no usable solution.
std::vector<VisitEvidence> evidence_of(const MapView& map, std::vector<DriveLeg> legs);

}  // namespace opal
