#pragma once

#include "geojson_reader.hpp"

#include <string>

namespace opal::geojson_importer {

/// Gives features that no rule knows a type, in three steps:
/// - Words of their kinds and uses. Walls of the plan's own say more than areas that are used for something: beside
/// such
///   walls, only walls, doors and the like are known by words.
/// - Where most areas with a property are rooms and corridors by words of it, the others with it are corridors: open
///   spaces, docks, what is called in another language. An area around others, as a building or a storey is, is none.
/// - What has no words at all is what the whole collection is called.
/// Features know their levels by then.
/// @param file  its name without folder and ending, for a collection without a name.
void find_types_by_words(const std::string& file, FeatureCollection& collection);

}  // namespace opal::geojson_importer
