#pragma once

#include "map/overlay/map_overlay.hpp"

#include <memory>
#include <string>

namespace opal::test {

/// A room of 8 m by 5 m: wall-1 to wall-4 with face-1 to face-4 counter-clockwise between corner-1 to corner-4, a
/// corner feature k1 at corner-1 as part of wall-1, and a column c1 with its rim; patterns of rim and face-1.
std::shared_ptr<const SemanticMap> room();

/// An overlay with these changes (JSON, comma-separated), and these nodes beside it.
MapOverlay overlay(const std::string& changes, const std::string& nodes = "",
                   const std::string& name = "room.overlay.jsonld");
OverlaidMap overlaid(const SemanticMap& map, const MapOverlay& overlay);

const MapFeature& feature(const SemanticMap& map, const std::string& id);
const MapObject& object(const SemanticMap& map, const std::string& id);
bool has_feature(const SemanticMap& map, const std::string& id);
/// The message of the MapError that applying gives; empty if it gives none.
std::string refusal(const SemanticMap& map, const std::vector<MapOverlay>& overlays);
std::string all_of(const std::vector<std::string>& sentences);

}  // namespace opal::test
