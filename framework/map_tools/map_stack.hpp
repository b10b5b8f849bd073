#pragma once

#include <opal/map/semantic_map.hpp>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace opal {

/// A map that becomes a storey. If it holds storeys itself, it is a building of a site, and they all come along.
struct StoreyPart {
  std::string id;                      ///< of the storey; what lies on it is named "ID/..."
  std::string name;                    ///< for people; may be empty
  std::optional<double> level_m = {};  ///< of its floor, in the building's coordinates
  std::shared_ptr<const SemanticMap> map;
};

struct StackOptions {
  std::string building;       ///< name of the building that the storeys belong to; empty: not said
  double gap_m = 150;         ///< between neighbouring sheets; at least kLeastSheetGap_m
  double same_place_m = 1.5;  ///< lifts and stairs of storeys are one if their middles are no farther apart
};

/// What became of the parts.
struct StackedMap {
  std::shared_ptr<const SemanticMap> map;
  std::vector<std::string> report;  ///< sentences: connections that were found, lifts that only one storey shows
};

/// Lays storeys side by side in one map, a sheet each, in the order given. Lifts and stairs that the parts show above
/// each other become one connection; storeys are compared in their own frames, so this takes storeys that were drawn in
/// common coordinates.
/// @throws ConfigError if there is nothing to stack, an id is used twice or is empty, or the gap is too small.
/// @throws MapError if a part has placements of its own, or nothing that has a position.
OPAL_EXPORT StackedMap stacked_map(const std::string& name, std::span<const StoreyPart> parts,
                                   const StackOptions& options = {});

/// The part of a map that lies on one storey, where it lies in the map; without patterns.
/// @param id_or_name  a name that several storeys have is none.
/// @throws ConfigError naming the storeys that there are.
OPAL_EXPORT std::shared_ptr<const SemanticMap> storey_of_map(const SemanticMap& map, const std::string& id_or_name);

/// The map with further buildings and connections, and other names of storeys, from a document that says nothing else:
/// {"@context": "urn:opal:v1", "@graph": [{"@id": "lift", "@type": "StoreyConnection", ...}]}.
/// @throws MapError, also for a landing that is far from all that lies on its storey.
OPAL_EXPORT StackedMap with_connections(const StackedMap& stacked, const std::string& file);

}  // namespace opal
