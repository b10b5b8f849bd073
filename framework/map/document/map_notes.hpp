#pragma once

#include "map/document/semantic_map_graph.hpp"

#include <opal/map/semantic_map.hpp>

namespace opal {

/// What sources say beyond places and looks, between documents and memory.

ObjectNotes read_object_notes(const GraphNode& node);
void write_notes(const ObjectNotes& notes, nlohmann::ordered_json& node);

/// All of a map's origin but smear and placements.
void read_origin_notes(const GraphNode& node, MapOrigin& origin);
void write_notes(const MapOrigin& origin, nlohmann::ordered_json& node);

}  // namespace opal
