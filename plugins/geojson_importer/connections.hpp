#pragma once

#include "geojson_reader.hpp"

#include <opal/map/semantic_map.hpp>

#include <string>
#include <vector>

namespace opal::geojson_importer {

/// Lifts and stairs on a level, each with its landing there, in the `map` frame: what OpenStreetMap (highway=elevator,
/// stairs=yes), IMDF (category elevator, stairs) or plain words say. A lift may be a point or an area, stairs are an
/// area.
/// @param collection  in its place. @param level  empty: all of it.
std::vector<MapConnection> connections_of(const FeatureCollection& collection, const std::string& level);

}  // namespace opal::geojson_importer
