#pragma once

#include <opal/semantic_map.hpp>

#include <nlohmann/json.hpp>

#include <vector>

namespace opal::postgis_store {

/// A map as a flat JSON-LD graph.
struct GraphRows {
  nlohmann::json context;
  std::vector<nlohmann::json> nodes;  ///< with an @id each, which several may share; other nodes only by reference
};

GraphRows graph_rows(const SemanticMap& map);

}  // namespace opal::postgis_store
