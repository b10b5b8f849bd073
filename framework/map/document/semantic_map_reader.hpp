#pragma once

#include "map/document/semantic_map_graph.hpp"
#include "map/semantic_map_draft.hpp"

namespace opal {

/// Finds the objects, features and patterns of a graph, wherever in the document they stand.
/// @throws MapError.
MapDraft read_graph(const Graph& graph, const std::string& source, const std::string& default_name);

}  // namespace opal
