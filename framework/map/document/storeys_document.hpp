#pragma once

#include "map/document/semantic_map_unused.hpp"

#include <opal/map/semantic_map.hpp>

namespace opal {

/// Buildings, storeys and connections of a document. A storey with a place in the map is a sheet; one without is kept
/// as unused, unless others have a place.
/// @throws MapError.
void read_storeys(const Graph& graph, NodeUses& uses, MapOrigin& origin);
/// Appends their nodes to a document.
void write_storeys(const MapOrigin& origin, nlohmann::ordered_json& graph);

}  // namespace opal
