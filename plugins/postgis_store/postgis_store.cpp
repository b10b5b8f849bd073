#include "postgis_store.hpp"

#include "feature_rows.hpp"
#include "graph_rows.hpp"
#include "schema.hpp"
#include "versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace opal::postgis_store {
namespace {

using nlohmann::json;

// Push ---------------------------------------------------------------------------------------------------------------

/// Locks the building until the end of the transaction: pushes of one building go one after the other.
/// @return id and newest version.
Row lock_building(Session& session, const std::string& building) {
  session.ask("INSERT INTO opal.buildings (name) VALUES ($1) ON CONFLICT DO NOTHING", {building});
  return session.ask("SELECT id, newest FROM opal.buildings WHERE name = $1 FOR UPDATE", {building}).at(0);
}

void expect_newest(const MapPush& request, int newest) {
  if (!request.expected_version || *request.expected_version == newest) return;
  const std::string is = newest == 0 ? "has no version yet" : fmt::format("is at version {}", newest);
  throw StoreConflict(fmt::format("building {} {}, expected version {}; nothing was pushed", quoted(request.building),
                                  is, *request.expected_version));
}

/// @return id of the map version.
std::string add_version(Session& session, const SemanticMap& map, const MapPush& request, const std::string& context) {
  const Row building = lock_building(session, request.building);
  const int newest = std::stoi(building.at(1));
  expect_newest(request, newest);
  const std::string version = std::to_string(newest + 1);
  session.ask("UPDATE opal.buildings SET newest = $2::integer WHERE id = $1::bigint", {building[0], version});
  return session
      .ask(
          "INSERT INTO opal.map_versions (building, version, message, map_name, context, objects, features, patterns, "
          "largest_radius_m) VALUES ($1::bigint, $2::integer, $3, $4, $5::jsonb, $6::integer, $7::integer, "
          "$8::integer, "
          "$9::float8) RETURNING id",
          {building[0], version, request.message, map.name(), context, std::to_string(map.objects().size()),
           std::to_string(map.features().size()), std::to_string(map.patterns().size()),
           json(largest_radius_m(map)).dump()})
      .at(0)
      .at(0);
}

/// Statements of moderate size: `work` gets a JSON array of some rows, and the position of the first.
template <class Work>
void in_batches(std::span<const std::string> rows, Work work) {
  constexpr std::size_t kRowsAtOnce = 10000;
  for (std::size_t first = 0; first < rows.size(); first += kRowsAtOnce) {
    std::string batch = "[";
    for (const std::string& row : rows.subspan(first, std::min(kRowsAtOnce, rows.size() - first)))
      batch.append(batch.size() > 1 ? "," : "").append(row);
    work(batch + "]", first);
  }
}

constexpr const char* kInsertNodes =
    "INSERT INTO opal.nodes (map, position, id, types, node) "
    "SELECT $1::bigint, $2::integer + ord - 1, node->>'@id', "
    "ARRAY(SELECT jsonb_array_elements_text(CASE jsonb_typeof(node->'@type') WHEN 'array' THEN node->'@type' "
    "WHEN 'string' THEN jsonb_build_array(node->'@type') ELSE '[]' END)), node "
    "FROM jsonb_array_elements($3::jsonb) WITH ORDINALITY AS n(node, ord)";

/// References to other nodes, alone, in arrays, and in JSON-LD lists.
constexpr const char* kInsertRelations =
    "INSERT INTO opal.node_relations (map, subject, relation, position, object) "
    "SELECT n.map, n.id, entry.key, member.ord - 1, member.value->>'@id' "
    "FROM opal.nodes n, jsonb_each(n.node) AS entry, "
    "jsonb_path_query(entry.value, 'lax $[*]') WITH ORDINALITY AS member(value, ord) "
    "WHERE n.map = $1::bigint AND jsonb_typeof(member.value) = 'object' AND member.value ? '@id' "
    "UNION ALL "
    "SELECT n.map, n.id, entry.key, member.ord - 1, member.value->>'@id' "
    "FROM opal.nodes n, jsonb_each(n.node) AS entry, "
    "jsonb_path_query(entry.value, 'lax $[*].\"@list\"[*]') WITH ORDINALITY AS member(value, ord) "
    "WHERE n.map = $1::bigint AND jsonb_typeof(member.value) = 'object' AND member.value ? '@id'";

void add_graph(Session& session, const std::string& map_id, std::span<const std::string> nodes) {
  in_batches(nodes, [&](const std::string& batch, std::size_t first) {
    session.ask(kInsertNodes, {map_id, std::to_string(first), batch});
  });
  session.ask(kInsertRelations, {map_id});
}

void add_features(Session& session, const std::string& map_id, const SemanticMap& map) {
  in_batches(feature_rows(map), [&](const std::string& batch, std::size_t) {
    session.ask(kInsertFeatures, {map_id, batch});
  });
}

void expect_push_storable(const GraphRows& graph, const MapPush& request) {
  expect_storable(request.message, "the message");
  expect_storable(graph.context, "the map's context");
  for (const std::string& node : graph.nodes) expect_storable(node, "node " + node.substr(0, 120) + " of the map");
}

// Pull ---------------------------------------------------------------------------------------------------------------

std::string document_of(Session& session, const std::string& map_id) {
  std::string text = "{\"@context\":" +
                     session.ask("SELECT context FROM opal.map_versions WHERE id = $1::bigint", {map_id}).at(0).at(0) +
                     ",\"@graph\":[\n";
  bool is_first = true;
  for (const Row& row : session.ask("SELECT node FROM opal.nodes WHERE map = $1::bigint ORDER BY position", {map_id})) {
    text.append(is_first ? "" : ",\n").append(row[0]);
    is_first = false;
  }
  return text + "\n]}\n";
}

// Spatial questions --------------------------------------------------------------------------------------------------

/// PostGIS computes distances by other formulas than Opal, which may differ in their last digits: it says which
/// features may be near, by this much more than asked for, and Opal decides.
constexpr double kSlack_m = 1e-6;

const std::string kNearCandidates =
    std::string("SELECT number, id, object, object_type, ") + kGeometryColumns +
    " FROM (SELECT f.*, CASE f.shape WHEN 'segment' THEN f.geom ELSE ST_MakeLine(f.geom, f.geom) END AS line "
    "FROM opal.features f, opal.map_versions v WHERE v.id = $1::bigint AND f.map = v.id AND f.sensor = $2 "
    "AND f.geom && ST_Expand(ST_MakePoint($3::float8, $4::float8), $5::float8 + v.largest_radius_m) "
    "AND CASE f.shape WHEN 'circle' THEN abs(ST_Distance(f.geom, ST_MakePoint($3::float8, $4::float8)) - f.radius_m) "
    "ELSE ST_Distance(f.geom, ST_MakePoint($3::float8, $4::float8)) END <= $5::float8) AS near ORDER BY number";

void expect_question(const NearQuery& query) {
  expect_name("building", query.building);
  expect_version(query.version);
  if (!query.center.allFinite() || !(query.radius_m >= 0) || !std::isfinite(query.radius_m))
    throw StoreError(
        "a question about what is near with a centre or a radius that is not finite, or a radius below zero");
}

std::string number(double value) { return json(value).dump(); }

}  // namespace

StoredVersion PostgisStore::push(const SemanticMap& map, const MapPush& request) const {
  expect_name("building", request.building);
  const GraphRows graph = graph_rows(map);
  expect_push_storable(graph, request);
  StoredVersion pushed;
  server_.transact([&](Session& session) {
    bring_up_to_date(session, where());
    const std::string map_id = add_version(session, map, request, graph.context);
    add_graph(session, map_id, graph.nodes);
    add_features(session, map_id, map);
    pushed = version_of(
        session.ask("SELECT " + version_columns() + " FROM opal.versions WHERE map = $1::bigint", {map_id}).at(0));
  });
  return pushed;
}

StoredMap PostgisStore::pull(const std::string& building, int version) const {
  expect_name("building", building);
  expect_version(version);
  StoredMap pulled;
  server_.read([&](Session& session) {
    require_schema(session, where());
    const FoundVersion found = find_version(session, where(), building, version);
    pulled = {found.version, document_of(session, found.map)};
  });
  return pulled;
}

std::vector<StoredVersion> PostgisStore::list(const std::string& building) const {
  std::vector<StoredVersion> versions;
  server_.read([&](Session& session) {
    require_schema(session, where());
    const std::string sql =
        "SELECT " + version_columns() +
        " FROM opal.versions WHERE building = $1 OR $1 = '' ORDER BY building COLLATE \"C\", version";
    for (const Row& row : session.ask(sql, {building})) versions.push_back(version_of(row));
  });
  return versions;
}

std::vector<NearFeature> PostgisStore::features_near(const NearQuery& query) const {
  expect_question(query);
  std::vector<NearFeature> near;
  server_.read([&](Session& session) {
    require_schema(session, where());
    const FoundVersion found = find_version(session, where(), query.building, query.version);
    for (const Row& row : session.ask(kNearCandidates, {found.map, query.sensor, number(query.center.x()),
                                                        number(query.center.y()), number(query.radius_m + kSlack_m)})) {
      NearFeature feature{
          MapFeatureNumber(std::stoi(row.at(0))), row.at(1), row.at(2), row.at(3), geometry_of(row, 4), 0};
      feature.distance_m = opal::distance_m(feature.geometry, query.center);
      if (feature.distance_m <= query.radius_m) near.push_back(std::move(feature));
    }
  });
  return near;
}

}  // namespace opal::postgis_store
