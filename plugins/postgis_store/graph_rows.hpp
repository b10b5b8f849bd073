#pragma once

#include <opal/map/semantic_map.hpp>

#include <string>
#include <vector>

namespace opal::postgis_store {

/// A map as a flat JSON-LD graph, in pieces of JSON.
struct GraphRows {
  std::string context;
  std::vector<std::string> nodes;  ///< with an @id each, which several may share; other nodes only by reference
};

GraphRows graph_rows(const SemanticMap& map);

}  // namespace opal::postgis_store
