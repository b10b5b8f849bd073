#include "import_source.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using nlohmann::json;

namespace {

json outlined(double x0, double y0, double x1, double y1) {
  return json::array({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}});
}

json shaped(const std::string& type, const json& coordinates, const std::string& word, const std::string& id) {
  return {{"type", "Feature"},
          {"id", id},
          {"geometry", {{"type", type}, {"coordinates", coordinates}}},
          {"properties", {{"class", word}}}};
}

MapImport import_shapes(const std::vector<json>& features, const json& options = json::object()) {
  return import_text("geojson_importer", "opal:GeoJsonImporter", "plan.geojson",
                     json{{"type", "FeatureCollection"}, {"features", features}}.dump(), options);
}

bool has_wall_at(const MapImport& plan, const Point& p) {
  const auto faces = all<Segment>(*plan.map);
  return std::any_of(faces.begin(), faces.end(), [&](const Segment& face) { return distance_m(face, p) < 0.01; });
}

}  // namespace

TEST_CASE("a wall that is drawn as a closed ring encloses a building, and is none by itself") {
  const json shell = shaped("Polygon", json::array({outlined(0, 0, 20, 10)}), "wall", "shell");
  const json inner = shaped("LineString", {{5, 0}, {5, 10}}, "wall", "inner");
  const json door = shaped("Point", {10, 0}, "door", "door");
  const MapImport plan = import_shapes({shell, inner, door});
  CHECK(has_wall_at(plan, {5, 5}));
  CHECK(has_face(*plan.map, {0, 10}, {0, 0}));
  CHECK(has_face(*plan.map, {0, 0}, {0, 10}));
  CHECK_FALSE(has_wall_at(plan, {10, 0}));
  CHECK(says(plan, "taken as thin walls along their outlines: 1 (shell)"));
  const MapImport massive = import_shapes({shell}, {{"max_wall_thickness_m", 5}, {"geographic", false}});
  CHECK(all<Segment>(*massive.map).size() == 8);  // 20 m x 10 m: 6.7 m thick
}

TEST_CASE("walls with thickness stay massive, also if they go around a building") {
  const MapImport plan = import_shapes(
      {shaped("Polygon", json::array({outlined(0, 0, 20, 10), outlined(0.4, 0.4, 19.6, 9.6)}), "wall", "s"),
       shaped("Polygon", json::array({outlined(5, 0.4, 5.2, 9.6)}), "wall", "w")});
  CHECK(has_face(*plan.map, {20, 0}, {0, 0}));
  CHECK_FALSE(has_face(*plan.map, {0, 0}, {20, 0}));
  CHECK_FALSE(says(plan, "thin walls along"));
}

TEST_CASE("doors that are lines or areas are cut into walls that are lines") {
  const json wall = shaped("LineString", {{0, 0}, {10, 0}}, "wall", "w");
  const json door = GENERATE(shaped("LineString", {{4, 0.05}, {5, 0.05}}, "door", "d"),
                             shaped("Polygon", json::array({outlined(4, -0.1, 5, 0.1)}), "door", "d"));
  const MapImport plan = import_shapes({wall, door});
  CHECK(has_face(*plan.map, {0, 0}, {4, 0}));
  CHECK(has_face(*plan.map, {5, 0}, {10, 0}));
  CHECK(all<Segment>(*plan.map).size() == 4);
  CHECK(says(plan, "doors and openings: 1 cut into walls, 0 where no wall is"));
}

TEST_CASE("doors within massive walls are told, for nothing is cut out of these") {
  const MapImport plan = import_shapes({shaped("Polygon", json::array({outlined(0, 0, 10, 0.2)}), "wall", "w"),
                                        shaped("LineString", {{1, 0.1}, {2, 0.1}}, "door", "line"),
                                        shaped("Point", {4, 0.1}, "door", "point"),
                                        shaped("Polygon", json::array({outlined(6, 0, 7, 0.2)}), "door", "area"),
                                        shaped("LineString", {{1, 5}, {2, 5}}, "door", "elsewhere")});
  CHECK(says(plan, "0 cut into walls, 1 where no wall is, 2 in massive walls"));
  CHECK(says(plan, "doubtful: doors that are closed by massive walls, which are not cut: 3 (area in w, line in w, "));
  CHECK(thing(plan, "point").reason == "it lies in the massive wall w, which is not cut");
}

TEST_CASE("areas of the type room or corridor have walls around them") {
  json room = shaped("Polygon", json::array({outlined(0, 0, 5, 4)}), "room", "room");
  json corridor = shaped("Polygon", json::array({outlined(0, 4, 9, 6)}), "corridor", "corridor");
  room["properties"] = {{"Type", "room"}};
  const MapImport plan = import_shapes({room, corridor});
  CHECK(has_wall_at(plan, {5, 2}));
  CHECK(has_wall_at(plan, {9, 5}));
  CHECK(says(plan, "walls were put around 2 areas"));
}
