#pragma once

#include <opal/map/semantic_map.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace opal {

/// A map that is to be joined with others.
struct MapSourcePart {
  std::string prefix;  ///< what it is called in the joined map: "acapulco" makes "acapulco/wall-0001"
  std::shared_ptr<const SemanticMap> map;
};

/// How maps are put side by side, and how many look-alikes are added, to measure what size alone does to a localizer.
struct MapJoin {
  double gap_m = 20;  ///< between the bounds of neighbours
  int copies = 0;     ///< of all sources together: mirrored, and stretched along x and y by 5 to 30 %
  std::uint64_t seed = 1;
};

/// Puts maps side by side in one map, in rows, moved by whole metres and not turned; the copies come after the
/// originals, named "copy-1/acapulco/...". origin().placements says where each lies. Patterns come along except those
/// of stretched copies, whose dimensions are no longer true; what other vocabularies say does not. The same arguments
/// give the same map.
/// @throws ConfigError if there is nothing to join, if a prefix is used twice or is empty, or if a number makes no
/// sense.
/// @throws MapError if a source has placements of its own, or nothing that has a position.
OPAL_EXPORT std::shared_ptr<const SemanticMap> joined_map(std::span<const MapSourcePart> sources, const MapJoin& join);

/// A shape in a placed map, in the joined map's frame. The visible side stays visible when it is mirrored; a circle
/// gets the mean radius of the ellipse that it becomes.
OPAL_EXPORT Geometry placed(const MapPlacement& placement, const Geometry& geometry_source);

/// What is said of an object, in the joined map's frame.
OPAL_EXPORT ObjectNotes placed(const MapPlacement& placement, ObjectNotes notes_source);

/// The placement of a source. @throws ConfigError naming those that there are.
OPAL_EXPORT const MapPlacement& placement_of(const SemanticMap& map, const std::string& id);

}  // namespace opal
