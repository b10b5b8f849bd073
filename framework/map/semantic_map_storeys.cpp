#include "map/semantic_map_storeys.hpp"

#include "common/phrases.hpp"
#include "map/map_vocabulary.hpp"

#include <algorithm>
#include <set>

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

// ---------------------------------------------------------------- checks

double gap_m(const std::array<Point, 2>& a, const std::array<Point, 2>& b) {
  return (a[0] - b[1]).cwiseMax(b[0] - a[1]).cwiseMax(Point::Zero()).norm();
}

std::string expected_storey(const std::vector<MapStorey>& storeys) {
  return storeys.empty() ? "no storey, for the map holds none" : "one of " + ids_of(storeys);
}

void measure(MapDraft& draft, MapStorey& storey) {
  const std::string prefix = storey.id + "/";
  bool is_empty = true;
  for (const MapFeature& feature : draft.features) {
    if (!feature.id.starts_with(prefix)) continue;
    const auto* circle = std::get_if<Circle>(&feature.geometry);
    const Point margin = Point::Constant(circle ? circle->radius_m : 0);
    for (const Point& p : points_of(feature.geometry)) {
      storey.bounds[0] = is_empty ? Point(p - margin) : Point(storey.bounds[0].cwiseMin(p - margin));
      storey.bounds[1] = is_empty ? Point(p + margin) : Point(storey.bounds[1].cwiseMax(p + margin));
      is_empty = false;
    }
  }
  if (is_empty)
    draft.fail("storey '" + storey.id + "'",
               "nothing lies on it, expected features whose ids begin with '" + prefix + "'");
}

void check_apart(const MapDraft& draft) {
  const std::vector<MapStorey>& storeys = draft.origin.storeys;
  for (std::size_t a = 0; a < storeys.size(); ++a)
    for (std::size_t b = a + 1; b < storeys.size(); ++b)
      if (const double gap = gap_m(storeys[a].bounds, storeys[b].bounds); gap < kLeastSheetGap_m)
        draft.fail("storey '" + storeys[b].id + "'",
                   "its sheet is " + opal::text_of(gap) + " m from that of '" + storeys[a].id +
                       "', expected at least " + opal::text_of(kLeastSheetGap_m) + " m; opal map stack places them");
}

/// Additions of an overlay need no prefix: they lie where some storey is.
void check_all_on_storeys(const MapDraft& draft) {
  const std::vector<MapStorey>& storeys = draft.origin.storeys;
  for (std::size_t i = 0; i < draft.features.size() && !storeys.empty(); ++i)
    for (const Point& p : points_of(draft.features[i].geometry)) {
      const auto near_enough = [&](const MapStorey& s) {
        return distance_to_box_m(s.bounds, p) < kLeastSheetGap_m / 4;
      };
      if (std::none_of(storeys.begin(), storeys.end(), near_enough))
        draft.fail(draft.feature_places[i], "feature '" + draft.features[i].id +
                                                "' lies on no storey, expected it within 25 m of what a storey holds");
    }
}

void check_connection(const MapDraft& draft, const MapConnection& connection) {
  const std::string place = "connection '" + connection.id + "'";
  if (!(connection.radius_m > 0 && connection.radius_m <= 100))
    draft.fail(place,
               "radius_m " + opal::text_of(connection.radius_m) + ", expected a positive number of metres up to 100");
  std::set<std::string> met;
  for (const Landing& landing : connection.landings) {
    const std::vector<MapStorey>& storeys = draft.origin.storeys;
    const bool is_known = storeys.empty() ? landing.storey.empty() : with_id(storeys, landing.storey) != nullptr;
    if (!is_known)
      draft.fail(place, "a landing on storey '" + landing.storey + "', expected " + expected_storey(storeys));
    if (!met.insert(landing.storey).second)
      draft.fail(place, "two landings on storey '" + landing.storey + "', expected one on each");
    const Pose2& T = landing.T_storey_landing;
    if (!(T.position().cwiseAbs().maxCoeff() <= kFarthest_m) || !std::isfinite(T.heading_rad()))
      draft.fail(place, "a landing that is not at a place, expected metres in the storey's frame, at most 1e6");
  }
}

void check_building(const MapDraft& draft, const MapStorey& storey) {
  if (!storey.building.empty() && with_id(draft.origin.buildings, storey.building) == nullptr)
    draft.fail("storey '" + storey.id + "'", "building '" + storey.building + "', expected one that the map names");
}

}  // namespace

std::string ids_of(const std::vector<MapStorey>& storeys) {
  std::vector<std::string> ids;
  for (const MapStorey& storey : storeys) ids.push_back(in_quotes(storey.id));
  return listed(ids);
}

void read_storeys(const Graph& graph, NodeUses& uses, MapOrigin& origin) { StoreyReader(graph, uses, origin).run(); }

void write_storeys(const MapOrigin& origin, Json& graph) {
  for (const MapBuilding& building : origin.buildings) graph.push_back(written(building, origin));
  for (const MapStorey& storey : origin.storeys) graph.push_back(written(storey));
  for (const MapConnection& connection : origin.connections) graph.push_back(written(connection));
}

void name_storeys(MapDraft& draft) {
  const auto compact = [&draft](std::string& name) { name = compact_name(name, draft.prefixes); };
  for (MapBuilding& building : draft.origin.buildings) compact(building.id);
  for (MapStorey& storey : draft.origin.storeys) {
    compact(storey.id);
    compact(storey.building);
  }
  for (MapConnection& connection : draft.origin.connections) {
    compact(connection.id);
    connection.type = compact_name(full_iri(connection.type), draft.prefixes);
    for (Landing& landing : connection.landings) compact(landing.storey);
  }
}

void sort_storeys(MapOrigin& origin) {
  const auto by_id = [](const auto& a, const auto& b) { return id_before(a.id, b.id); };
  std::stable_sort(origin.buildings.begin(), origin.buildings.end(), by_id);
  std::stable_sort(origin.storeys.begin(), origin.storeys.end(), by_id);
  std::stable_sort(origin.connections.begin(), origin.connections.end(), by_id);
  for (MapConnection& connection : origin.connections)
    std::stable_sort(connection.landings.begin(), connection.landings.end(),
                     [](const Landing& a, const Landing& b) { return id_before(a.storey, b.storey); });
}

void check_storeys(MapDraft& draft) {
  for (MapStorey& storey : draft.origin.storeys) {
    measure(draft, storey);
    check_building(draft, storey);
  }
  check_apart(draft);
  check_all_on_storeys(draft);
  for (const MapConnection& connection : draft.origin.connections) check_connection(draft, connection);
}

}  // namespace opal
