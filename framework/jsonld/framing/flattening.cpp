// JSON-LD 1.1 API, 7.2: Flattening.
#include "jsonld/framing/node_map.hpp"

#include <utility>

namespace opal::json_ld {
namespace {

Json listed(NodeGraph& graph) {
  Json nodes = Json::array();
  for (auto& [id, entry] : graph)
    if (!entry.is_mere_reference()) nodes.push_back(std::move(entry.json()));
  return nodes;
}

}  // namespace

Json flatten(const Json& document, const Options& options) {
  NodeMap node_map(expand(document, options));
  NodeGraph& main = node_map.graphs()[kDefaultGraph];
  for (auto& [name, graph] : node_map.graphs())
    if (&graph != &main) node_of(main, name).json()["@graph"] = listed(graph);
  return listed(main);
}

}  // namespace opal::json_ld
