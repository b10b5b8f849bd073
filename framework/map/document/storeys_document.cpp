#include "map/document/storeys_document.hpp"

#include "map/map_vocabulary.hpp"
#include "map/semantic_map_storeys.hpp"

#include <algorithm>

namespace opal {
namespace {

using namespace vocabulary;
using Json = nlohmann::ordered_json;

/// A lift that two people fit in.
constexpr double kUsualRadius_m = 1.0;

bool is_sheet(const GraphNode& node) {
  return node.has_type(iri::kStoreyType) && (node.has(iri::kX) || node.has(iri::kY));
}

void require_id(const GraphNode& node, const char* reason) {
  if (is_blank(node.id())) node.fail(node.description() + ", expected an @id, " + reason);
}

class StoreyReader {
 public:
  StoreyReader(const Graph& graph, NodeUses& uses, MapOrigin& origin) : graph_(graph), uses_(uses), origin_(origin) {}

  void run() {
    const auto& nodes = graph_.nodes();
    if (std::any_of(nodes.begin(), nodes.end(), is_sheet))
      for (const GraphNode& node : nodes)
        if (node.has_type(iri::kStoreyType)) read_storey(node);
    for (const GraphNode& node : nodes)
      if (node.has_type(iri::kBuilding)) read_building(node);
    for (const GraphNode& node : nodes)
      if (node.has_type(iri::kConnection)) read_connection(node);
    for (const GraphNode& node : nodes)
      if (node.has_type(iri::kLanding) && !use_of(node).plays(NodeRole::landing))
        node.fail(node.description() + " belongs to no connection, expected landings that refer to it");
  }

 private:
  NodeUse& use_of(const GraphNode& node) { return uses_[node.position()]; }

  void read_storey(const GraphNode& node) {
    require_id(node, "which is the prefix of what lies on it");
    use_of(node).add(NodeRole::storey);
    MapStorey storey{node.id(), node.text(iri::kName).value_or("")};
    storey.level_m = node.number(iri::kLevel);
    storey.origin = {node.required_number(iri::kX), node.required_number(iri::kY)};
    origin_.storeys.push_back(std::move(storey));
  }

  /// A building none of whose storeys is a sheet is kept, but not used.
  void read_building(const GraphNode& node) {
    const auto is_known = [&](const GraphReference& reference) { return find(reference.id) != nullptr; };
    const std::vector<GraphReference> parts = node.references(iri::kHasStorey);
    if (std::none_of(parts.begin(), parts.end(), is_known)) return;
    require_id(node, "by which its storeys can name it");
    use_of(node).add(NodeRole::building);
    origin_.buildings.push_back({node.id(), node.text(iri::kName).value_or("")});
    for (const GraphReference& reference : parts) {
      MapStorey* storey = find(reference.id);
      if (storey == nullptr)
        node.fail_at(reference.place, node.description() + " has the storey '" + reference.id +
                                          "', expected a Storey with x and y, as the others are");
      if (!storey->building.empty())
        node.fail_at(reference.place, "storey '" + storey->id + "' belongs to '" + storey->building + "' and to '" +
                                          node.id() + "', expected one building");
      storey->building = node.id();
    }
  }

  void read_connection(const GraphNode& node) {
    require_id(node, "by which answers can name it");
    use_of(node).add(NodeRole::connection);
    MapConnection connection{node.id(), node.required_reference(iri::kConnectionType).id,
                             node.text(iri::kName).value_or(""), node.number(iri::kRadius).value_or(kUsualRadius_m)};
    for (const GraphReference& reference : node.references(iri::kLandings))
      connection.landings.push_back(landing(graph_.at(reference, node)));
    if (connection.landings.empty()) node.fail(node.description() + " has no landings, expected some");
    origin_.connections.push_back(std::move(connection));
  }

  Landing landing(const GraphNode& node) {
    if (!node.has_type(iri::kLanding)) node.fail(node.description() + " is used as a landing, expected @type Landing");
    if (use_of(node).plays(NodeRole::landing))
      node.fail(node.description() + " belongs to two connections, expected one");
    use_of(node).add(NodeRole::landing);
    const std::optional<GraphReference> storey = node.reference(iri::kOnStorey);
    return {storey ? storey->id : "", Pose2(node.required_number(iri::kX), node.required_number(iri::kY),
                                            node.number(iri::kHeading).value_or(0))};
  }

  MapStorey* find(const std::string& id) { return with_id(origin_.storeys, id); }

  const Graph& graph_;
  NodeUses& uses_;
  MapOrigin& origin_;
};

Json written(const MapStorey& storey) {
  Json node = {{"@id", storey.id}, {"@type", "Storey"}};
  if (!storey.name.empty()) node["name"] = storey.name;
  if (storey.level_m) node["level_m"] = *storey.level_m;
  node["x"] = storey.origin.x();
  node["y"] = storey.origin.y();
  return node;
}

Json written(const MapBuilding& building, const MapOrigin& origin) {
  Json node = {{"@id", building.id}, {"@type", "Building"}};
  if (!building.name.empty()) node["name"] = building.name;
  for (const MapStorey& storey : origin.storeys)
    if (storey.building == building.id) node["has_storey"].push_back(storey.id);
  return node;
}

Json written(const Landing& landing) {
  Json node = {{"@type", "Landing"}};
  if (!landing.storey.empty()) node["on_storey"] = landing.storey;
  node["x"] = landing.T_storey_landing.x();
  node["y"] = landing.T_storey_landing.y();
  node["heading_rad"] = landing.T_storey_landing.heading_rad();
  return node;
}

Json written(const MapConnection& connection) {
  Json node = {{"@id", connection.id}, {"@type", "StoreyConnection"}};
  node["connection_type"] = short_term(connection.type);
  if (!connection.name.empty()) node["name"] = connection.name;
  node["radius_m"] = connection.radius_m;
  for (const Landing& landing : connection.landings) node["landings"].push_back(written(landing));
  return node;
}

}  // namespace

void read_storeys(const Graph& graph, NodeUses& uses, MapOrigin& origin) { StoreyReader(graph, uses, origin).run(); }

void write_storeys(const MapOrigin& origin, Json& graph) {
  for (const MapBuilding& building : origin.buildings) graph.push_back(written(building, origin));
  for (const MapStorey& storey : origin.storeys) graph.push_back(written(storey));
  for (const MapConnection& connection : origin.connections) graph.push_back(written(connection));
}

}  // namespace opal
