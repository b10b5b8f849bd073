#include "import_source.hpp"

#include "map/check/map_check.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

using namespace opal;
using Catch::Contains;
using nlohmann::json;

namespace {

json indoor(const std::string& type, const json& coordinates, json properties, const std::string& id) {
  return {{"type", "Feature"},
          {"id", id},
          {"geometry", {{"type", type}, {"coordinates", coordinates}}},
          {"properties", std::move(properties)}};
}

json area(double x0, double y0, double x1, double y1, json properties, const std::string& id) {
  return indoor("Polygon", json::array({{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}}}), std::move(properties),
                id);
}

json plan_of(const std::vector<json>& features) { return {{"type", "FeatureCollection"}, {"features", features}}; }

MapImport import_plan(const json& document, const json& options = json::object()) {
  return import_text("geojson_importer", "opal:GeoJsonImporter", "plan.geojson", document.dump(), options);
}

/// Whether a wall stands at a place.
bool has_wall(const MapImport& plan, const Point& p) {
  const auto faces = all<Segment>(*plan.map);
  return std::any_of(faces.begin(), faces.end(), [&](const Segment& face) { return distance_m(face, p) < 0.01; });
}

/// A folder with files in it, which goes away with this.
class Archive {
 public:
  Archive() : file_("manifest.json", "{}"), folder_(std::filesystem::path(file_.path()).parent_path()) {}
  void add(const std::string& name, const json& document) const { std::ofstream(folder_ / name) << document.dump(); }
  std::string path(const std::string& name = "") const { return (folder_ / name).string(); }

 private:
  TemporaryFile file_;
  std::filesystem::path folder_;
};

MapImport import_path(const std::string& path, const json& options = json::object()) {
  PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/geojson_importer.so");
  const auto importer = registry.make<MapImporter>("opal:GeoJsonImporter", options);
  CHECK(importer->recognizes(path));
  return importer->import(path);
}

const json kRoom{{"indoor", "room"}}, kCorridor{{"indoor", "corridor"}}, kArea{{"indoor", "area"}};

}  // namespace

TEST_CASE("walls stand around rooms of OpenStreetMap, and none between corridors and open areas") {
  const MapImport plan =
      import_plan(plan_of({area(0, 0, 5, 4, kRoom, "a"), area(5, 0, 9, 4, kRoom, "b"), area(0, 4, 9, 6, kCorridor, "c"),
                           area(9, 4, 12, 6, kCorridor, "d"), area(9, 0, 12, 4, kArea, "e")}));
  CHECK(has_wall(plan, {5, 2}));         // between rooms
  CHECK(has_wall(plan, {2, 4}));         // between a room and a corridor
  CHECK(has_wall(plan, {9, 2}));         // between a room and an open area
  CHECK(has_wall(plan, {4, 6}));         // a corridor's outer wall
  CHECK_FALSE(has_wall(plan, {9, 5}));   // between corridors
  CHECK_FALSE(has_wall(plan, {10, 4}));  // between a corridor and an open area
  CHECK_FALSE(has_wall(plan, {12, 2}));  // around an open area
  CHECK(has_wall(plan, {12, 5}));
  CHECK(check_map(*plan.map).warnings.empty());
  CHECK(says(plan, "walls were put around 5 areas"));
}

TEST_CASE("a door is cut into the walls on both sides of it, as wide as it says") {
  const MapImport plan = import_plan(plan_of(
      {area(0, 0, 5, 4, kRoom, "a"), area(0, 4.2, 5, 6, kCorridor, "c"),
       indoor("Point", {2, 4}, {{"door", "hinged"}}, "door"), indoor("Point", {4.9, 4}, {{"door", "no"}}, "gap"),
       indoor("Point", {0, 2}, {{"entrance", "main"}, {"width", "1.6 m"}}, "entrance"),
       indoor("Point", {2.5, 2}, {{"door", "yes"}}, "lost")}));
  for (const double y : {4.0, 4.2}) {
    CHECK_FALSE(has_wall(plan, {1.6, y}));
    CHECK(has_wall(plan, {1.5, y}));
    CHECK_FALSE(has_wall(plan, {2.4, y}));
    CHECK(has_wall(plan, {2.5, y}));
    CHECK_FALSE(has_wall(plan, {4.2, y}));
  }
  CHECK(has_wall(plan, {5, 3.9}));  // a door at a corner does not go around it
  CHECK_FALSE(has_wall(plan, {0, 1.25}));
  CHECK(has_wall(plan, {0, 1.15}));
  const MapCheck check = check_map(*plan.map);
  CHECK(check.objects_by_type.at("opal:Door") == 2);
  CHECK(check.warnings.empty());
  CHECK(thing(plan, "lost").reason == "no wall is within 0.6 m of it");
}

TEST_CASE("doors are cut into walls that are lines, too") {
  const MapImport plan = import_plan(plan_of({indoor("LineString", {{0, 0}, {6, 0}}, {{"indoor", "wall"}}, "w"),
                                              indoor("Point", {3, 0}, {{"door", "yes"}, {"width", 1}}, "d")}));
  CHECK(has_face(*plan.map, {0, 0}, {2.5, 0}));
  CHECK(has_face(*plan.map, {3.5, 0}, {6, 0}));
  CHECK(all<Segment>(*plan.map).size() == 4);
}

TEST_CASE("tags may stand in an object of their own, levels may be repeated, rooms may be closed lines") {
  json room = indoor("LineString", {{0, 0}, {5, 0}, {5, 4}, {0, 4}, {0, 0}},
                     {{"tags", {{"indoor", "room"}, {"level", "1"}, {"repeat_on", "3-4"}}}, {"type", "way"}}, "a");
  room["properties"].erase("type");
  CHECK(all<Segment>(*import_plan(plan_of({room}), {{"storey", "4"}}).map).size() == 8);
  CHECK_THROWS_WITH(import_plan(plan_of({room}), {{"storey", "2"}}), Contains("expected one of '1', '3', '4'"));
}

TEST_CASE("an archive of IMDF is read as one, by any of its files or its folder") {
  const Archive archive;
  const auto unit = [](json made, const char* category, const char* level) {
    made["feature_type"] = "unit";
    made["properties"] = {{"category", category}, {"level_id", level}};
    return made;
  };
  const auto level = [](const char* id, int ordinal, const char* name) {
    json made = area(0, 0, 9, 6, {{"ordinal", ordinal}, {"name", {{"en", name}}}, {"category", "unspecified"}}, id);
    made["feature_type"] = "level";
    return made;
  };
  json opening = indoor("LineString", {{2, 4}, {3, 4}}, {{"category", "pedestrian"}, {"level_id", "L0"}}, "o");
  opening["feature_type"] = "opening";
  archive.add("level.geojson", plan_of({level("L0", 0, "Ground"), level("L1", 1, "Concourse")}));
  archive.add("opening.geojson", plan_of({opening}));
  archive.add("unit.geojson",
              plan_of({unit(area(0, 0, 5, 4, {}, "a"), "room", "L0"), unit(area(0, 4, 9, 6, {}, "c"), "walkway", "L0"),
                       unit(area(5, 0, 9, 4, {}, "h"), "walkway.island", "L0"),
                       unit(area(0, 0, 9, 6, {}, "u"), "room", "L1")}));
  for (const char* file : {"", "unit.geojson", "opening.geojson", "level.geojson"}) {
    CAPTURE(file);
    const MapImport plan = import_path(archive.path(file), {{"geographic", false}});
    CHECK(has_wall(plan, {1.9, 4}));
    CHECK_FALSE(has_wall(plan, {2.5, 4}));  // the opening
    CHECK_FALSE(has_wall(plan, {7, 4}));    // between walkways
    CHECK(has_wall(plan, {5, 2}));
    CHECK(check_map(*plan.map).objects_by_type.at("opal:Door") == 1);
  }
  PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/geojson_importer.so");
  const auto storeys = registry.make<MapImporter>("opal:GeoJsonImporter", json::object())->storeys(archive.path());
  REQUIRE(storeys.size() == 2);
  CHECK(storeys[1].name == "Concourse");
  CHECK(storeys[1].gives == std::map<std::string, int>{{"category=room", 1}});
  CHECK(says(import_path(archive.path(), {{"geographic", false}}),
             "level '0' (Ground) of '0' (Ground), '1' (Concourse)"));
  const MapImport above = import_path(archive.path(), {{"geographic", false}, {"storey", "Concourse"}});
  CHECK(all<Segment>(*above.map).size() == 8);
}

TEST_CASE("what is damaged or far away is no matter where nothing is made of it") {
  const auto town = [](const json& properties) {
    return plan_of({area(5.48, 51.44, 5.4802, 51.4401, kRoom, "a"), indoor("Point", {6.9, 52.2}, properties, "far"),
                    indoor("Polygon", json::array({{{0, 0}, {1, 0}, {1, 1}}}), {{"shop", "yes"}}, "broken"),
                    indoor("Polygon", json::array(), {{"indoor", "wall"}}, "empty"),
                    area(5.48, 51.44, 5.481, 51.441, {}, "a")});
  };
  const MapImport plan = import_plan(town({{"place", "town"}}));
  CHECK(check_map(*plan.map).bounds[1].x() == Approx(6.95).margin(0.02));
  CHECK(thing(plan, "broken").reason == "no class for it");
  CHECK(thing(plan, "empty").reason == "it has no geometry");
  CHECK(says(plan, "features whose id another one has, and that have another now: 1"));
}

TEST_CASE("rooms beyond any building are refused") {
  CHECK_THROWS_WITH(import_plan(plan_of({area(0, 0, 1e300, 4, kRoom, "a"), area(0, 0, 5, 4, kCorridor, "b")})),
                    Contains("'a': a position at") && Contains("within 1e6 m of the origin"));
}

TEST_CASE("a crs of 2008 says degrees, metres, or the plane of web maps") {
  const auto with = [](json document, const char* name) {
    document["crs"] = {{"type", "name"}, {"properties", {{"name", name}}}};
    return document;
  };
  const json small = plan_of({area(5.48, 51.44, 5.4802, 51.4401, kRoom, "a")});
  CHECK(says(import_plan(with(small, "urn:ogc:def:crs:OGC:1.3:CRS84")), "WGS 84"));
  const double x = 6378137 * 5.48 * std::numbers::pi / 180, y = 6703000;
  const json web = plan_of({area(x, y, x + 16, y + 16, kRoom, "a")});
  const MapImport plan = import_plan(with(web, "urn:ogc:def:crs:EPSG::3857"));
  CHECK(check_map(*plan.map).bounds[1].x() == Approx(8 * std::cos(51.44 * std::numbers::pi / 180)).margin(0.03));
  const json utm = plan_of({area(412000, 5700000, 412010, 5700008, kRoom, "a")});
  CHECK(says(import_plan(with(utm, "urn:ogc:def:crs:EPSG::25832"), {{"origin_x_m", 412000}, {"origin_y_m", 5700000}}),
             "coordinates in metres (urn:ogc:def:crs:EPSG::25832)"));
}

TEST_CASE("lifts and stairs of a level come into the map as connections, walls around them as of any room") {
  const json document =
      plan_of({area(0, 0, 20, 10, {{"indoor", "room"}, {"level", "1"}}, "hall"),
               area(4, 4, 6, 7, {{"indoor", "room"}, {"highway", "elevator"}, {"level", "0-2"}}, "shaft"),
               area(10, 4, 14, 7, {{"indoor", "area"}, {"stairs", "yes"}, {"level", "1;2"}}, "steps"),
               indoor("Point", {8, 8}, {{"highway", "elevator"}, {"level", "1"}}, "node"),
               area(16, 4, 18, 6, {{"type", "elevator"}, {"level", "2"}}, "above")});
  const MapImport plan = import_plan(document, {{"storey", "1"}, {"geographic", false}});
  const auto& connections = plan.map->origin().connections;
  REQUIRE(connections.size() == 3);
  CHECK(connections[0].id == "node/lift");
  CHECK(connections[1].id == "shaft/lift");
  CHECK(connections[1].type == "opal:Lift");
  CHECK(connections[1].radius_m == Approx(1));
  CHECK(connections[1].landings.front().T_storey_landing.x() == Approx(5));
  CHECK(connections[1].landings.front().T_storey_landing.y() == Approx(5.5));
  CHECK(connections[2].type == "opal:Stair");
  CHECK(has_wall(plan, {5, 4}));
  CHECK(plan.map->origin().storey == "1");
}
