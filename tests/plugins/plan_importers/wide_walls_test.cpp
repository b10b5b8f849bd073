// Walls that are drawn as lines and say how thick they are, and levels that relations say.
#include "import_source.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using nlohmann::json;

namespace {

json feature(const json& geometry, json properties, const std::string& id) {
  return {{"type", "Feature"}, {"id", id}, {"geometry", geometry}, {"properties", std::move(properties)}};
}

json line(const json& coordinates, json properties, const std::string& id) {
  return feature({{"type", "LineString"}, {"coordinates", coordinates}}, std::move(properties), id);
}

MapImport import_features(const json& features, const json& options = json::object()) {
  return import_text("geojson_importer", "opal:GeoJsonImporter", "plan.geojson",
                     json{{"type", "FeatureCollection"}, {"features", features}}.dump(), options);
}

/// In one direction or the other.
bool has_line(const SemanticMap& map, const Point& a, const Point& b) {
  return has_face(map, a, b) || has_face(map, b, a);
}

double length_m(const SemanticMap& map) {
  double length = 0;
  for (const Segment& face : all<Segment>(map)) length += face.length_m();
  return length;
}

}  // namespace

TEST_CASE("a ring of walls is as thick as its width says, with square corners inside and outside") {
  const MapImport plan = import_features(
      json::array({line({{0, 0}, {20, 0}, {20, 12}, {0, 12}, {0, 0}}, {{"indoor", "wall"}, {"width", 0.3}}, "ring"),
                   line({{8, 0}, {8, 5}}, {{"indoor", "wall"}, {"width", "15 cm"}}, "partition")}));
  CHECK(has_line(*plan.map, {-0.15, -0.15}, {20.15, -0.15}));
  CHECK(has_line(*plan.map, {19.85, 0.15}, {8.075, 0.15}));
  CHECK(has_line(*plan.map, {8.075, 0.15}, {8.075, 5}));
  CHECK(all<Segment>(*plan.map).size() == 4 + 5 + 3);
  CHECK(says(plan, "walls drawn as lines that are as thick as their width says: 2"));
}

TEST_CASE("doors are cut out of walls that have a width") {
  const MapImport plan = import_features(
      json::array({line({{0, 0}, {10, 0}}, {{"indoor", "wall"}, {"width", 0.2}}, "w"),
                   feature({{"type", "Point"}, {"coordinates", {5, 0}}}, {{"door", "yes"}, {"width", 1}}, "d")}));
  CHECK(has_line(*plan.map, {0, -0.1}, {4.5, -0.1}));
  CHECK(has_line(*plan.map, {4.5, -0.1}, {4.5, 0.1}));
  CHECK(length_m(*plan.map) == Approx(2 * (2 * 4.5 + 2 * 0.2)));
}

TEST_CASE("walls meet on the line that halves their angle, and all others go on to the far face") {
  const MapImport bent =
      import_features(json::array({line({{0, 0}, {5, 0}, {9, 3}}, {{"indoor", "wall"}, {"width", 0.2}}, "bent")}));
  CHECK(all<Segment>(*bent.map).size() == 6);
  const MapImport cross =
      import_features(json::array({line({{0, 0}, {5, 0}}, {{"indoor", "wall"}, {"width", 0.2}}, "a"),
                                   line({{5, 0}, {10, 0}}, {{"indoor", "wall"}, {"width", 0.2}}, "b"),
                                   line({{5, 0}, {5, 5}}, {{"indoor", "wall"}, {"width", 0.2}}, "c")}));
  CHECK(length_m(*cross.map) == Approx(10 + 2 * 4.9 + 2 * 4.9 + 3 * 0.2).margin(1e-6));
}

TEST_CASE("a width that no wall has is told, and the wall stays thin") {
  for (const json& width : {json(3), json("250"), json(0.001)}) {
    const MapImport plan =
        import_features(json::array({line({{0, 0}, {10, 0}}, {{"indoor", "wall"}, {"width", width}}, "w")}));
    CHECK(
        says(plan, "doubtful: walls drawn as lines whose width is no thickness of a wall, taken as thin walls: 1 (w)"));
    CHECK(length_m(*plan.map) == Approx(20));
  }
}

TEST_CASE("a relation that is a level says the level of its members") {
  const auto room = [](double x, const char* key, const json& relations, const std::string& id) {
    json properties{{"type", "way"}, {"tags", {{"buildingpart", "room"}}}};
    properties[key] = relations;
    return feature({{"type", "Polygon"}, {"coordinates", {{{x, 0}, {x + 4, 0}, {x + 4, 3}, {x, 3}, {x, 0}}}}},
                   std::move(properties), id);
  };
  const auto level = [](const std::string& name) {
    return json{{"role", "buildingpart"}, {"rel", "1"}, {"reltags", {{"type", "level"}, {"level", name}}}};
  };
  const json other{{"rel", 2}, {"reltags", {{"type", "building"}, {"level", "7"}}}};
  const MapImport plan =
      import_features(json::array({room(0, "relations", json::array({other, level("0")}), "ground"),
                                   room(1, "@relations", json::array({level("1")}), "first"),
                                   room(6, "relations", json::array({level("0"), level("1")}), "both")}));
  CHECK(thing(plan, "ground").status == ImportStatus::imported);
  CHECK(thing(plan, "first").status == ImportStatus::not_cut);
  CHECK(thing(plan, "both").status == ImportStatus::imported);
  CHECK(says(plan, "level '0' of '0', '1'"));
}
