#pragma once

#include "geojson_reader.hpp"

#include <optional>
#include <string>
#include <utility>

namespace opal::geojson_importer {

/// What a feature is by words in the properties that say kinds and uses: "USE_TYPE": "Conference Room" and "room":
/// "toilets" are rooms, "Category": "Hallway" is a corridor, "type": "Wall - Interior" is a wall. Rooms and corridors
/// are areas. Nothing, if no word is known.
/// @return the object type, and the property that says it: "room=toilets".
std::optional<std::pair<std::string, std::string>> class_by_words(const Feature& feature);

/// Whether a property says what a thing is, or what it is used for, by its name: "USE_TYPE".
bool is_kind_key(const std::string& key);

/// What all features of a collection are that is called "walls", "Rooms" or "outer_walls"; nothing for another name.
std::optional<std::string> class_by_name(const std::string& collection);

}  // namespace opal::geojson_importer
