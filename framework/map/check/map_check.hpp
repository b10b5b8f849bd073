#pragma once

#include <opal/map/semantic_map.hpp>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace opal {

/// What a person wants to know of a map before a robot drives by it.
struct OPAL_EXPORT MapCheck {
  std::map<std::string, int> objects_by_type;
  std::map<std::string, int> features_by_type;
  std::map<std::string, int> features_by_sensor;  ///< "" for features that no sensor perceives
  std::array<int, 4> features_by_geometry{};      ///< by GeometryKind
  std::map<std::string, int> patterns_by_template;
  std::map<std::string, int> features_by_storey;          ///< by id; empty: the map is one storey
  std::map<std::string, int> connections_by_type;         ///< lifts and stairs
  double wall_length_m = 0;                               ///< of all segments
  int shared_points = 0;                                  ///< points that belong to more than one feature
  std::array<Point, 2> bounds{Point(0, 0), Point(0, 0)};  ///< min and max corner [m]; both zero for an empty map
  /// What may be a mistake, one sentence each; the map is usable all the same.
  std::vector<std::string> warnings;

  /// The whole check in sentences, in reading order; warnings last.
  std::vector<std::string> sentences() const;
};

/// Counts, extent, and what looks like a mistake: equal geometry given twice, features far from all others, points
/// closer than 1 cm that are not shared, objects that nothing represents, what people get wrong by hand, properties
/// that Opal makes no use of.
OPAL_EXPORT MapCheck check_map(const SemanticMap& map);

}  // namespace opal
