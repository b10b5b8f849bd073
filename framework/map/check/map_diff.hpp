#pragma once

#include <opal/map/semantic_map.hpp>

#include <string>
#include <vector>

namespace opal {

enum class MapPart { map, object, feature, pattern };
enum class ChangeKind {
  added,
  removed,
  moved,    ///< only features and placements; by moved_m
  retyped,  ///< another type of object, another feature type, another template
  altered   ///< anything else that the map says of it
};

/// One thing that differs between two maps. What differs in several ways has several changes.
struct MapChange {
  MapPart part = MapPart::map;
  ChangeKind kind = ChangeKind::altered;
  std::string id;      ///< of the object, feature or pattern; empty for the map as a whole
  double moved_m = 0;  ///< farthest that one of its points (ends, corner, centre) moved
  std::string detail;  ///< in words, for people: "opal:Wall, now opal:Door"
};

/// What became of a map.
struct OPAL_EXPORT MapDiff {
  std::vector<MapChange> changes;  ///< the map as a whole, objects, features, patterns; each in order of id

  bool empty() const { return changes.empty(); }
  /// Counts first ("features: 2 added, 1 moved (by at most 0.120 m)"), then a sentence per change. Of equal maps: none.
  std::vector<std::string> sentences() const;
};

/// Compares two maps id by id; features by id and sensor. Empty if and only if both are the same map: then their
/// documents are equal, too.
OPAL_EXPORT MapDiff map_diff(const SemanticMap& before, const SemanticMap& after);

}  // namespace opal
