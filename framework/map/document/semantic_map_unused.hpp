#pragma once

#include "map/document/semantic_map_graph.hpp"

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace opal {

/// What a node is to the map. A node may be several: a point that is also a feature.
enum class NodeRole {
  map,
  object,
  element,
  representation,
  sensor,
  segment,
  corner,
  circle,
  point,
  feature,
  pattern,
  placement,
  building,
  storey,
  connection,
  landing
};

/// Which properties and types of a node the typed map holds, by the roles that the node plays.
struct NodeUse {
  std::uint32_t roles = 0;  ///< one bit for each NodeRole
  std::string object_type;  ///< of an object: types are open

  bool any() const { return roles != 0; }
  bool plays(NodeRole role) const { return (roles >> static_cast<int>(role) & 1) != 0; }
  void add(NodeRole role) { roles |= 1u << static_cast<int>(role); }
  bool holds_property(std::string_view iri) const;
  bool holds_type(std::string_view iri) const;
  std::vector<std::string> properties() const;
};
/// By position in Graph::nodes().
using NodeUses = std::vector<NodeUse>;

/// What a node says beyond its use, without pointers; null if that is nothing but its id.
nlohmann::json unused_part(const GraphNode& node, const NodeUse& use);

/// The unused parts of all nodes, in an order and with blank labels that do not depend on the order of the document.
/// @param names  names given to blank nodes.
nlohmann::json unused_parts(const Graph& graph, const NodeUses& uses,
                            const std::unordered_map<std::string, std::string>& names);

}  // namespace opal
