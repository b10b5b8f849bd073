#pragma once

#include <opal/common/feature.hpp>
#include <opal/map/semantic_map.hpp>

#include <span>
#include <vector>

namespace opal {

/// A mapped feature as patterns see it: one feature, or several faces that lie on one line.
struct MappedFeature {
  Feature feature;                        ///< in the map frame
  std::vector<MapFeatureNumber> numbers;  ///< along the line
};

struct SupportLineOptions {
  double min_length_m = 0.4;  ///< shorter faces support no line
  double angle_rad = 0.05;
  double offset_m = 0.12;
  double gap_m = 3.0;  ///< doors and clutter interrupt a wall; its line goes on
};

/// Joins faces that look the same way along one line. Order of `faces` does not matter for the result's set.
std::vector<MappedFeature> support_lines(const SemanticMap& map, std::vector<MapFeatureNumber> faces,
                                         const SupportLineOptions& options);

/// What patterns are searched among: support lines, and every other perceivable feature as it is.
std::vector<MappedFeature> mapped_features(const SemanticMap& map, std::span<const MapFeatureNumber> perceivable);

}  // namespace opal
