#pragma once

#include "geojson_reader.hpp"

#include <string>
#include <vector>

namespace opal::geojson_importer {

/// The levels that a feature is on, as OpenStreetMap writes them in the properties `level` and `repeat_on`: "1", "0;1",
/// "-1-2" (-1, 0, 1, 2), or a number. None: it does not say, and is on all of them.
std::vector<std::string> levels_of(const Feature& feature);

bool is_on_level(const Feature& feature, const std::string& level);

/// All levels, from the lowest; names that are no numbers come last.
std::vector<std::string> all_levels(const FeatureCollection& collection);

/// The level that is nearest to the ground, 0, of those that something becomes of; the first if none is a number.
std::string level_at_ground(const FeatureCollection& collection);

}  // namespace opal::geojson_importer
