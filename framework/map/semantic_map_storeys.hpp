#pragma once

#include "map/semantic_map_draft.hpp"
#include "map/semantic_map_unused.hpp"

namespace opal {

/// Buildings, storeys and connections of a document. A storey with a place in the map is a sheet; one without is kept
/// as unused, unless others have a place.
/// @throws MapError.
void read_storeys(const Graph& graph, NodeUses& uses, MapOrigin& origin);
/// Appends their nodes to a document.
void write_storeys(const MapOrigin& origin, nlohmann::ordered_json& graph);

/// Full IRIs and bare terms become prefixed names, as `name_everything` does for the rest.
void name_storeys(MapDraft& draft);
/// In natural order of id; landings in that of their storeys.
void sort_storeys(MapOrigin& origin);

/// Measures each sheet; sheets are apart, everything lies on one, and connections connect storeys that there are.
/// @throws MapError.
void check_storeys(MapDraft& draft);

}  // namespace opal
