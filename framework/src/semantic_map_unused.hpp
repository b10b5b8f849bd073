#pragma once

#include "semantic_map_graph.hpp"

#include <set>
#include <string>
#include <unordered_map>

namespace opal {

/// Which properties and types of a node the typed map holds.
struct NodeUse {
  std::set<std::string> properties;
  std::set<std::string> types;
};
using NodeUses = std::unordered_map<std::string, NodeUse>;

/// What a node says beyond its uses, without pointers; null if that is nothing but its id.
nlohmann::json unused_part(const GraphNode& node, const NodeUses& uses);

/// The unused parts of all nodes, in an order and with blank labels that do not depend on the order of the document.
/// @param names  names given to blank nodes.
nlohmann::json unused_parts(const Graph& graph, const NodeUses& uses,
                            const std::unordered_map<std::string, std::string>& names);

}  // namespace opal
