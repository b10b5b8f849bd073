#pragma once

#include <opal/common/named.hpp>
#include <opal/map/view/map_view.hpp>
#include "patterns/pattern_index.hpp"

#include <string>
#include <vector>

namespace opal {

struct PatternLayerOptions {
  double size_m = 12;  ///< neighbours in a pattern are no farther apart
};

/// How much a template's patterns say about where one is.
struct PatternSummary {
  std::string pattern_template;
  int patterns = 0;
  int unique = 0;        ///< patterns that no other looks like
  int median_alike = 0;  ///< half of them have at most this many look-alikes
  int most_alike = 0;
  int members = 0;     ///< features that are in a pattern,
  int candidates = 0;  ///< of those whose shape could be
};
/// "opal:ColumnPair: 26 patterns, 2 unique; ...": for people.
OPAL_EXPORT std::string sentence_of(const PatternSummary& summary);

/// Patterns in a map, template by template (Hendrikx 2023, 4.4.1).
struct PatternLayer {
  std::vector<MapPattern> patterns;
  std::vector<int> alike;  ///< for each pattern, how many others of its template look like it within tolerance
  std::vector<PatternSummary> summaries;
};

/// Finds them: neighbours see each other, that is, the line between them meets no geometry that the sensor perceives,
/// and are no farther apart than options.size_m. Patterns that contain smaller ones name them as subpatterns.
OPAL_EXPORT PatternLayer find_pattern_layer(const MapView& map, const std::vector<Named<PatternTemplate>>& templates,
                                            const PatternLayerOptions& options = {});

/// The same numbers for the layer that the map holds. @throws MapError as layer_instances.
OPAL_EXPORT PatternLayer read_pattern_layer(const MapView& map, const std::vector<Named<PatternTemplate>>& templates);

/// The patterns of the map's layer that name this template, as its instances; members are positions in
/// MapView::features(). Members of a symmetric pattern may stand in either order.
/// @throws MapError naming file, place and pattern if its members form no instance, or not with these dimensions.
OPAL_EXPORT std::vector<PatternInstance> layer_instances(const MapView& map, const std::string& name,
                                                         const PatternTemplate& pattern_template);
/// Whether a pattern of the map, or any of them, is for the sensor of this view.
OPAL_EXPORT bool is_for_sensor(const MapView& map, const MapPattern& pattern);
OPAL_EXPORT bool has_pattern_layer(const MapView& map);

}  // namespace opal
