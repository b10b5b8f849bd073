// Features that no rule knows: words of their kinds and uses, the name of the collection, and places on Earth.
#include "import_source.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;
using nlohmann::json;

namespace {

/// A box of 4 m x 3 m, or of so many degrees, at a place.
json box(double x, json properties, double unit = 1, double x0 = 0, double y0 = 0) {
  json ring = json::array();
  for (const auto& [u, v] : {std::pair(0, 0), {4, 0}, {4, 3}, {0, 3}, {0, 0}})
    ring.push_back({x0 + unit * (x + u), y0 + unit * v});
  return {{"type", "Feature"},
          {"properties", std::move(properties)},
          {"geometry", {{"type", "Polygon"}, {"coordinates", {ring}}}}};
}

json line(json properties) {
  return {{"type", "Feature"},
          {"properties", std::move(properties)},
          {"geometry", {{"type", "LineString"}, {"coordinates", {{0, 9}, {10, 9}}}}}};
}

MapImport import_all(const std::vector<json>& features, json more = json::object(),
                     const std::string& file = "plan.geojson") {
  more.update({{"type", "FeatureCollection"}, {"features", features}});
  return import_text("geojson_importer", "opal:GeoJsonImporter", file, more.dump());
}

}  // namespace

TEST_CASE("areas are rooms and corridors by words of their use") {
  for (const json& properties :
       {json{{"type", "Toilet"}}, json{{"USE_TYPE", "Conference Room"}}, json{{"room", "anything"}},
        json{{"typ", "Raum"}}, json{{"amenity", "toilets"}, {"level", "0"}}, json{{"stairs", "yes"}},
        json{{"Kategorie", "Büro"}}}) {
    CAPTURE(properties);
    CHECK(says(import_all({box(0, properties)}), "as opal:Room: 1 Polygon"));
  }
  const MapImport plan = import_all({box(0, {{"use", "Lift lobby"}}), box(4, {{"use", "Hallway"}})});
  CHECK(says(plan, "class use=Hallway as opal:Corridor: 1 Polygon"));
  CHECK(all<Segment>(*plan.map).size() == 8);  // around both
}

TEST_CASE("walls and doors are known by words, and then areas of a use are none") {
  const MapImport plan = import_all({line({{"USE_TYPE", "Wall - Interior"}}), box(0, {{"USE_TYPE", "Office"}})});
  CHECK(says(plan, "class USE_TYPE=Wall - Interior as opal:Wall: 1 LineString"));
  CHECK(says(plan, "no class for it: class USE_TYPE=Office"));
  CHECK(says(import_all({line({{"name", "wall_12"}})}), "class name=wall_12 as opal:Wall"));
}

TEST_CASE("what stands outside, describes something or is a line is no room") {
  for (const json& properties : {json{{"amenity", "toilets"}}, json{{"type", "the way from the office to the hall"}},
                                 json{{"name", "Toilet"}}, json{{"room", "no"}}}) {
    CAPTURE(properties);
    CHECK_THROWS_WITH(import_all({box(0, properties)}), Contains("no feature gives anything for a map"));
  }
  CHECK_THROWS_WITH(import_all({line({{"type", "corridor of the office"}})}), Contains("no feature gives anything"));
}

TEST_CASE("other kinds beside rooms are corridors, but for what lies around rooms") {
  const auto of_type = [](double x, const char* type) { return box(x, {{"type", type}}); };
  json building = of_type(0, "Gebäude");
  building["geometry"]["coordinates"][0] = {{-1, -1}, {30, -1}, {30, 9}, {-1, 9}, {-1, -1}};
  const std::vector<json> rooms{of_type(0, "Büro"), of_type(4, "Lager"), of_type(8, "WC")};
  std::vector<json> more = rooms;
  more.insert(more.end(), {of_type(12, "Open Space"), building});
  const MapImport plan = import_all(more);
  CHECK(says(plan, "class type=Open Space as opal:Corridor: 1 Polygon"));
  CHECK(says(plan, "no class for it: class type=Gebäude"));
  std::vector<json> storeys;
  for (json room : rooms) {
    room["properties"]["level"] = "1";
    storeys.push_back(std::move(room));
  }
  json above = building;
  above["properties"] = {{"type", "Open Space"}, {"level", "0"}};
  storeys.push_back(above);
  CHECK(says(import_all(storeys), "class type=Open Space as opal:Corridor"));
  const MapImport few = import_all({rooms[0], of_type(12, "Open Space")});
  CHECK(says(few, "no class for it: class type=Open Space"));
}

TEST_CASE("a collection that is called walls or rooms holds these, if nothing in it says more") {
  CHECK(says(import_all({line({{"fid", 1}})}, {{"name", "outer_walls"}}), "every feature taken for opal:Wall"));
  CHECK(says(import_all({box(0, {{"fid", 1}})}, json::object(), "Rooms.geojson"), "is called 'Rooms'"));
  CHECK_THROWS_WITH(import_all({line({{"fid", 1}})}, {{"name", "routes"}}), Contains("no feature gives anything"));
  CHECK_FALSE(says(import_all({line({{"class", "wall"}}), line({{"fid", 1}})}, {{"name", "walls"}}), "every feature"));
}

TEST_CASE("rings that are not closed are closed, and that is told") {
  json open = box(0, {{"class", "room"}});
  open["geometry"]["coordinates"][0].erase(4);
  const MapImport plan = import_all({open});
  CHECK(all<Segment>(*plan.map).size() == 8);
  CHECK(says(plan, "doubtful: rings whose last position is not their first, and that were closed: 1"));
}

TEST_CASE("positions with the latitude first are turned around where they can be nothing else") {
  json swapped = box(0, {{"class", "room"}}, 1e-5, 36.47, 127.14);
  const MapImport plan = import_all({swapped});
  CHECK(says(plan, "doubtful: positions have the latitude first"));
  CHECK(says(plan, "around 127.14"));
}

TEST_CASE("a plan in a national grid gets an origin near it, and options say another one") {
  const MapImport plan = import_all({box(0, {{"class", "room"}}, 1, 412345, 5654321)});
  CHECK(says(plan, "the map's origin is at 412000, 5654000 m of the plan"));
  CHECK(has_face(*plan.map, {345, 321}, {349, 321}));
}

TEST_CASE("levels may run from above, a collection may be a bare array, and other formats are named") {
  const json low = box(0, {{"indoor", "room"}, {"level", "-1--3"}}),
             other = box(9, {{"indoor", "room"}, {"level", "0"}});
  CHECK(says(import_all({low, other}), "level '0' of '-3', '-2', '-1', '0'"));
  const auto import_document = [](const json& document) {
    return import_text("geojson_importer", "opal:GeoJsonImporter", "plan.geojson", document.dump());
  };
  CHECK(says(import_document(json::array({low, other})), "indoor=room as opal:Room"));
  CHECK_THROWS_WITH(import_document({{"geometryType", "esriGeometryPolygon"}, {"features", json::array()}}),
                    Contains("JSON of ArcGIS, expected GeoJSON"));
  CHECK_THROWS_WITH(import_all({}), Contains("plan.geojson: has no features"));
}
