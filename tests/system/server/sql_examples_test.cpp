// The questions of docs/map_store.md, asked.
#include "made_maps.hpp"
#include "plugins/postgis_store/server.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

using namespace opal;
using namespace opal::store_tests;

namespace {

using Rows = std::vector<postgis_store::Row>;

/// The blocks of SQL of the page, in order.
std::vector<std::string> examples() {
  std::ifstream page(OPAL_SOURCE_DIR "/docs/map_store.md");
  std::vector<std::string> blocks;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line == "```sql")
      blocks.emplace_back();
    else if (inside && line != "```")
      blocks.back() += line + "\n";
    inside = line == "```sql" || (inside && line != "```");
  }
  return blocks;
}

std::string example_with(const std::string& words) {
  for (const std::string& example : examples())
    if (example.find(words) != std::string::npos) return example;
  FAIL("no example with " << words);
  return {};
}

Rows rows_of_answer(const std::string& sql) {
  Rows rows;
  postgis_store::Server({}).read([&](postgis_store::Session& session) { rows = session.ask(sql); });
  return rows;
}

std::set<std::string> column(const Rows& rows, std::size_t k) {
  std::set<std::string> values;
  for (const auto& row : rows) values.insert(row.at(k));
  return values;
}

Map example_room() { return SemanticMap::read(OPAL_SOURCE_DIR "/maps/example_room.jsonld"); }

/// The thesis' question, answered in the process.
std::set<std::string> walls_and_doors_within(const SemanticMap& map, const Point& place, double radius_m) {
  std::set<std::string> ids;
  for (const MapFeature& feature : map.features()) {
    const std::string& type = map.object(feature.object).type;
    if ((type == "opal:Wall" || type == "opal:Door") && feature.sensor == "PlanarLidar2D" &&
        distance_m(feature.geometry, place) <= radius_m)
      ids.insert(feature.id);
  }
  return ids;
}

}  // namespace

TEST_CASE("every statement of the page about the map store works") {
  store()->push(*example_room(), {"example"});
  REQUIRE(examples().size() >= 6);
  for (const std::string& example : examples()) {
    CAPTURE(example);
    CHECK_NOTHROW(postgis_store::Server({}).transact([&](postgis_store::Session& session) { session.run(example); }));
  }
}

TEST_CASE("the thesis' question has the same answer from flat rows, from the graph and from the map") {
  for (const Map& map : {example_room(), malaga()}) {
    store()->push(*map, {"example"});
    const auto expected = walls_and_doors_within(*map, {0, 0}, 10);
    REQUIRE(expected.size() >= 4);
    const Rows flat = rows_of_answer(example_with("f.object_type IN ('opal:Door', 'opal:Wall')"));
    CHECK(column(flat, 2) == expected);
    const Rows graph = rows_of_answer(example_with("DISTINCT ON (o.id, o.geometry)"));
    CHECK(column(graph, 2) == expected);
    CHECK(column(flat, 1) == column(graph, 1));
    for (const auto& row : flat) CHECK(nlohmann::json::parse(row.at(4)).at("@id") == row.at(2));
  }
}

TEST_CASE("SQL sees the whole graph") {
  store()->push(*rich_map(), {"rich"});
  const auto of_newest = [](const std::string& sql) {
    return rows_of_answer("SELECT " + sql +
                          " JOIN opal.versions v USING (map) WHERE v.building = 'rich' AND v.is_newest");
  };
  const auto has = [&](const std::string& subject, const std::string& relation, const std::string& object) {
    return !rows_of_answer(
                "SELECT 1 FROM opal.node_relations JOIN opal.versions v USING (map) WHERE v.building = 'rich' AND "
                "v.is_newest "
                "AND subject = '" +
                subject + "' AND relation = '" + relation + "' AND object = '" + object + "'")
                .empty();
  };
  CHECK(has("w1", "represented_by", "r1"));
  CHECK(has("r1", "perceivable_by", "PlanarLidar2D"));
  CHECK(has("r1", "represented_by", "s1"));
  CHECK(has("s1", "end", "p2"));
  CHECK(has("pair", "features", "other:c"));
  CHECK(has("pairs", "subpatterns", "pair"));
  CHECK(has("w1", "https://acme.example/types#next", "k''1"));
  CHECK(has("w1", "https://acme.example/types#steps", "w1"));
  const auto ids = column(of_newest("id FROM opal.nodes"), 0);
  for (const char* id : {"w1", "k'1", "s1", "p1", "p2", "other:c", "pair", "hall", "unused-circle", "PlanarLidar2D"})
    CHECK(ids.count(id) == 1);
  CHECK(of_newest("id FROM opal.nodes").size() == ids.size());
  CHECK(column(of_newest("shape FROM opal.features"), 0) ==
        std::set<std::string>{"circle", "corner", "point", "segment"});
}

TEST_CASE("the walls that robots have seen elsewhere, from what their drives say") {
  store()->push(*example_room(), {"example"});
  const auto drive = [](const std::string& verdict, double offset_m) {
    const nlohmann::json object{{"object", "south_wall"}, {"verdict", verdict}, {"offset_m", offset_m}};
    return nlohmann::json{{"visits", {{{"objects", {object}}}}}}.dump();
  };
  const int newest = store()->pull("example", 0).version.version;
  store()->add_evidence("example", newest, {drive("moved", 0.2), drive("moved", 0.3), drive("as mapped", 0)});
  const Rows rows = rows_of_answer(example_with("opal.drive_evidence e"));
  REQUIRE(rows.size() == 1);
  CHECK(rows[0] == postgis_store::Row{"south_wall", "2", "0.25"});
}
