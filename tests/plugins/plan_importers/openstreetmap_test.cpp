// Extracts of OpenStreetMap as JOSM, the site and Overpass write them: XML and JSON.
#include "import_source.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>
#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;

namespace {

// 0.0001 degrees are 11.1 m here, in both directions.
std::string node(int id, int x, int y, const std::string& tags = "") {
  return fmt::format("<node id='{}' version='1' visible='true' lat='{:.5f}' lon='{:.5f}'>{}</node>\n", id, y * 1e-5,
                     x * 1e-5, tags);
}

std::string way(int id, const std::vector<int>& nodes, const std::string& tags, const std::string& more = "") {
  std::string text = fmt::format("<way id='{}' {}>", id, more);
  for (const int n : nodes) text += fmt::format("<nd ref='{}'/>", n);
  return text + tags + "</way>\n";
}

std::string tag(const std::string& key, const std::string& value) {
  return fmt::format("<tag k='{}' v='{}'/>", key, value);
}

/// Two rooms side by side with a door between them; the nodes 1 to 6 are their corners.
std::string two_rooms() {
  const std::string room = tag("indoor", "room") + tag("level", "0");
  return node(1, 0, 0) + node(2, 8, 0) + node(3, 8, 6) + node(4, 0, 6) + node(5, 16, 0) + node(6, 16, 6) +
         node(7, 8, 3, tag("door", "hinged") + tag("level", "0")) + way(10, {1, 2, 7, 3, 4, 1}, room) +
         way(11, {2, 5, 6, 3, 7, 2}, room);
}

MapImport import_osm(const std::string& content, const std::string& name = "rooms.osm") {
  return import_text(
      "geojson_importer", "opal:GeoJsonImporter", name,
      "<?xml version='1.0' encoding='UTF-8'?>\n<osm version='0.6' generator='JOSM'>\n" + content + "</osm>\n");
}

MapImport import_overpass(const nlohmann::json& elements) {
  return import_text(
      "geojson_importer", "opal:GeoJsonImporter", "overpass.json",
      nlohmann::json{{"version", 0.6}, {"osm3s", nlohmann::json::object()}, {"elements", elements}}.dump());
}

}  // namespace

TEST_CASE("XML of OpenStreetMap is read as it is: rooms with the door between them") {
  const MapImport plan = import_osm(two_rooms());
  CHECK(says(plan, "indoor=room as opal:Room: 2 Polygon"));
  CHECK(says(plan, "doors and openings: 1 cut into walls"));
  CHECK(thing(plan, "way/10").status == ImportStatus::imported);
  // Around the middle of both: 1.11 m a unit.
  CHECK(all<Segment>(*plan.map).size() >= 12);
}

TEST_CASE("what an editor has deleted is no part of the map, and the other forms of the file are read alike") {
  const std::string deleted = way(12, {1, 2, 3, 4, 1}, tag("indoor", "wall"), "action='delete'") +
                              way(13, {1, 2, 3, 4, 1}, tag("indoor", "wall"), "visible='false'");
  const MapImport plan = import_osm(two_rooms() + deleted, "ROOMS.XML");
  CHECK(says(plan, "indoor=room as opal:Room: 2 Polygon"));
  CHECK_FALSE(says(plan, "indoor=wall"));
}

TEST_CASE("relations of OpenStreetMap give levels and rooms with holes") {
  const std::string level = "<relation id='20'><member type='way' ref='14' role='shell'/>" + tag("type", "level") +
                            tag("level", "3") + "</relation>";
  const std::string holed = node(21, 2, 2) + node(22, 4, 2) + node(23, 4, 4) +
                            way(14, {1, 2, 3}, tag("indoor", "wall")) + way(15, {3, 4, 1}, "") +
                            way(16, {1, 2, 3}, "") + way(17, {21, 22, 23, 21}, "") +
                            "<relation id='30'><member type='way' ref='16' role='outer'/><member type='way' ref='15' "
                            "role='outer'/><member type='way' ref='17' role='inner'/>" +
                            tag("type", "multipolygon") + tag("indoor", "room") + tag("level", "3") + "</relation>";
  const std::string corners = node(1, 0, 0) + node(2, 8, 0) + node(3, 8, 6) + node(4, 0, 6);
  const std::string above = way(18, {1, 2, 3, 4, 1}, tag("indoor", "room") + tag("level", "4"));
  const MapImport plan = import_osm(corners + holed + level + above);
  CHECK(plan.map->origin().storey == "3");
  CHECK(says(plan, "indoor=room as opal:Room: 1 MultiPolygon"));
  CHECK(thing(plan, "relation/30").status == ImportStatus::imported);
  CHECK(thing(plan, "way/14").status == ImportStatus::imported);
}

TEST_CASE("ways of which an extract holds a part only are left out and told") {
  const MapImport plan = import_osm(two_rooms() + way(12, {1, 99}, tag("indoor", "wall")));
  CHECK(says(plan, "of which the file holds a part only: 1 (way/12)"));
}

TEST_CASE("the JSON of Overpass is read as it is, with nodes or with the geometry of ways") {
  using nlohmann::json;
  const json tags = {{"indoor", "room"}, {"level", "0"}};
  const json corners = json::array({{{"lat", 0.0}, {"lon", 0.0}},
                                    {{"lat", 0.0}, {"lon", 8e-5}},
                                    {{"lat", 6e-5}, {"lon", 8e-5}},
                                    {{"lat", 0.0}, {"lon", 0.0}}});
  const MapImport drawn =
      import_overpass({{{"type", "way"}, {"id", 5}, {"nodes", {1, 2, 3, 1}}, {"geometry", corners}, {"tags", tags}}});
  json elements = json::array({{{"type", "way"}, {"id", 5}, {"nodes", {1, 2, 3, 1}}, {"tags", tags}}});
  for (int k = 0; k < 3; ++k) {
    json corner = corners[static_cast<std::size_t>(k)];
    corner.update({{"type", "node"}, {"id", k + 1}});
    elements.push_back(corner);
  }
  const MapImport counted = import_overpass(elements);
  CHECK(all<Segment>(*drawn.map).size() == 6);
  CHECK(all<Segment>(*counted.map).size() == 6);
}

TEST_CASE("damaged XML of OpenStreetMap names the line") {
  CHECK_THROWS_WITH(import_osm("<node id='1' lat='x' lon='0'/>"),
                    Contains("rooms.osm:3: node: lat=\"x\", expected a number"));
  CHECK_THROWS_WITH(import_osm("<node id='1'"), Contains("rooms.osm:3: not valid XML"));
  CHECK_THROWS_WITH(import_osm("<way id='1'><nd/></way>"), Contains("nd: no ref, expected a number"));
  CHECK_THROWS_WITH(import_text("geojson_importer", "opal:GeoJsonImporter", "a.osm",
                                "<?xml version='1.0'?>\n<!DOCTYPE osm [<!ENTITY a 'b'>]>\n<osm/>"),
                    Contains("a document type"));
}

TEST_CASE("damaged JSON of Overpass names the place") {
  using nlohmann::json;
  CHECK_THROWS_WITH(import_overpass({{{"type", "node"}, {"id", 1}, {"lat", "x"}, {"nodes", {1}}}}),
                    Contains("/elements/0: a node without lat and lon"));
  CHECK_THROWS_WITH(import_overpass({{{"type", "way"}, {"nodes", {1}}}}),
                    Contains("/elements/0: no id, expected an integer"));
}

TEST_CASE("an object of OpenStreetMap that comes twice is one object") {
  const std::string wall = way(10, {1, 2, 3, 4, 1}, tag("indoor", "wall")), corners = two_rooms();
  const std::string bare = way(10, {}, "") + way(10, {1, 2, 3, 4, 1}, "");
  CHECK(import_osm(corners + wall + bare).map->features().size() == import_osm(corners + wall).map->features().size());
  CHECK(import_osm(corners + wall + wall).report == import_osm(corners + wall).report);
}

TEST_CASE("XML of Overpass that states where the nodes of a way are needs no nodes") {
  const auto at = [](int x, int y) {
    return fmt::format("<nd ref='{}' lat='{:.5f}' lon='{:.5f}'/>", 100 * x + y, y * 1e-5, x * 1e-5);
  };
  const std::string ring = at(0, 0) + at(8, 0) + at(8, 6) + at(0, 6) + at(0, 0), room = tag("indoor", "room");
  const auto whole = import_osm("<way id='10'>" + ring + room + "</way>").map;
  CHECK(whole->features().size() >= 4);
  const auto member = import_osm("<relation id='1'><member type='way' ref='10' role='outer'>" + ring + "</member>" +
                                 room + tag("type", "multipolygon") + "</relation>")
                          .map;
  CHECK(member->features().size() == whole->features().size());
}
