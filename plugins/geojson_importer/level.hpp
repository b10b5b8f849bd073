#pragma once

#include "geojson_reader.hpp"

#include <string>
#include <vector>

namespace opal::geojson_importer {

/// Finds out on which levels each feature is, as OpenStreetMap writes them in the properties `level` and `repeat_on`:
/// "1", "0;1", "-1-2" (-1, 0, 1, 2), or a number. A plan without `level` and `level_id` may say them in floor, floorId,
/// floor_id or storey. Upper and lower case are the same.
/// @param path      stands for the file in messages.
/// @param property  says the levels, and no other one does; empty: as above.
/// @throws MapError if no feature has the property that is asked for.
void find_levels(const std::string& path, const std::string& property, FeatureCollection& collection);

/// Sentences about properties that are called like levels, have several values and are not taken for levels; none if
/// there are levels.
std::vector<std::string> doubts_about_levels(const FeatureCollection& collection);

bool is_on_level(const Feature& feature, const std::string& level);

/// All levels, from the lowest; names that are no numbers come last.
std::vector<std::string> all_levels(const FeatureCollection& collection);

/// Whether a level is a number, which says how far from the ground it is; others are names.
bool is_numbered(const std::string& level);

/// The level that is nearest to the ground, 0, of those that something becomes of; the first if none is a number.
std::string level_at_ground(const FeatureCollection& collection);

}  // namespace opal::geojson_importer
