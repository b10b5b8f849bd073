#include "import_source.hpp"

#include "map/check/map_check.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;
using nlohmann::json;

namespace {

json drawn(const std::string& type, const json& coordinates, json properties, const std::string& id) {
  return {{"type", "Feature"},
          {"id", id},
          {"geometry", {{"type", type}, {"coordinates", coordinates}}},
          {"properties", std::move(properties)}};
}

/// A wall of 10 m at a height y, and something else.
json with_wall(const std::vector<json>& others) {
  json features = json::array({drawn("LineString", {{0, 0}, {10, 0}}, {{"indoor", "wall"}}, "w")});
  for (const json& other : others) features.push_back(other);
  return {{"type", "FeatureCollection"}, {"features", features}};
}

MapImport import_drawn(const std::string& text, const json& options = json::object()) {
  return import_text("geojson_importer", "opal:GeoJsonImporter", "plan.geojson", text, options);
}

std::shared_ptr<const MapImporter> geojson_importer() {
  static const PluginRegistry kRegistry = [] {
    PluginRegistry registry;
    registry.load(OPAL_PLUGIN_DIR "/geojson_importer.so");
    return registry;
  }();
  return kRegistry.make<MapImporter>("opal:GeoJsonImporter", json::object());
}

Point size_of(const MapImport& plan) {
  const MapCheck check = check_map(*plan.map);
  return check.bounds[1] - check.bounds[0];
}

}  // namespace

TEST_CASE("damage of features without a class is told, and refuses the file where a map would be made of it") {
  const auto damaged = [](const std::string& what, json properties) {
    json feature = drawn("Point", {1, 1}, std::move(properties), "poi");
    if (what == "properties") feature["properties"] = json::array();
    if (what == "id") feature["id"] = {{"$oid", "5f1e0c"}};
    if (what == "geometry") feature.erase("geometry");
    if (what == "type") feature.erase("type");
    return with_wall({feature}).dump();
  };
  for (const std::string what : {"properties", "id", "geometry", "type"}) {
    CAPTURE(what);
    const MapImport plan = import_drawn(damaged(what, {{"name", "desk"}}));
    CHECK(all<Segment>(*plan.map).size() == 2);
    CHECK(plan.elements.size() == 2);
    CHECK(says(plan, "damaged, and nothing is made of them: 1 features, the first: "));
    CHECK(says(plan, "plan.geojson: /features/1"));
    if (what != "properties")
      CHECK_THROWS_WITH(import_drawn(damaged(what, {{"indoor", "wall"}})), Contains("plan.geojson: /features/1"));
  }
  CHECK(all<Segment>(*import_drawn(with_wall({json("no feature")}).dump()).map).size() == 2);
}

TEST_CASE("NaN in the place of a number is damage: told without a class, refused with one") {
  const auto with = [](const std::string& tag, const std::string& property, const std::string& x) {
    json plan =
        with_wall({drawn("LineString", {{0, 1}, {"X", 1}}, {{tag, "wall"}, {"of", "NaN"}, {"height", "P"}}, "o")});
    std::string text = plan.dump(1);
    text.replace(text.find("\"P\""), 3, property);
    return text.replace(text.find("\"X\""), 3, x);
  };
  const std::string number = GENERATE("NaN", "Infinity", "-Infinity");
  const MapImport plan = import_drawn(with("name", number, "10"));
  CHECK(all<Segment>(*plan.map).size() == 2);
  CHECK(says(plan, "in the place of a number, which is no JSON: 1, the first in line"));
  CHECK(says(plan, "/features/1/properties/height: " + number + ", expected a number"));
  CHECK(all<Segment>(*import_drawn(with("name", "3", number)).map).size() == 2);
  CHECK_THROWS_WITH(import_drawn(with("indoor", number, "10")), Contains("/features/1/properties/height: " + number));
  CHECK_THROWS_WITH(import_drawn(with("indoor", "3", number)), Contains("/features/1/geometry/coordinates/1/0: "));
  CHECK_THROWS_WITH(import_drawn(with("name", "NaNa", "10")), Contains("plan.geojson: line "));
}

TEST_CASE("a plan is known whatever the case of its ending and the order of its members") {
  const TemporaryFolder folder;
  const std::string text = R"({"features": [{"type": "Feature", "geometry": null, "properties": {"a": ")" +
                           std::string(9000, 'x') + R"("}}], "type": "FeatureCollection"})";
  CHECK(geojson_importer()->recognizes(folder.write("last.json", text)));
  CHECK(geojson_importer()->recognizes(folder.write("PLAN.GEOJSON", text)));
  CHECK(geojson_importer()->recognizes(folder.write("plan.Json", R"({"type": "FeatureCollection"})")));
  CHECK_FALSE(geojson_importer()->recognizes(folder.write("other.json", R"({"@graph": []})")));
  CHECK_FALSE(geojson_importer()->recognizes(folder.write("empty.json", "")));
}

TEST_CASE("formats of OpenStreetMap itself are recognized, and refused if they hold no plan") {
  const TemporaryFolder folder;
  const std::string xml = folder.write("base.osm", "<?xml version='1.0'?>\n<osm version=\"0.6\"></osm>");
  const std::string overpass = folder.write(
      "base.json", R"({"version": 0.6, "elements": [{"type": "node", "id": 1, "lat": 5, "lon": 5, "tags": {}}]})");
  for (const std::string& path : {xml, overpass}) {
    REQUIRE(geojson_importer()->recognizes(path));
    CHECK_THROWS_WITH(geojson_importer()->import(path), Contains(path + ": has no features"));
    CHECK(geojson_importer()->storeys(path).empty());
  }
}

TEST_CASE("levels are found in floor, floorId and storey, too, or in the property that is named") {
  const auto on = [](const std::string& key, const json& value, double y, const std::string& id) {
    return drawn("LineString", {{0, y}, {10, y}}, {{"type", "wall"}, {key, value}}, id);
  };
  for (const std::string key : {"floor", "floorId", "floor_id", "Storey", "LEVEL"}) {
    CAPTURE(key);
    const std::string text = with_wall({on(key, 1, 2, "one"), on(key, 2, 4, "two"), on(key, 2, 6, "three")}).dump();
    const MapImport plan = import_drawn(text);
    CHECK(thing(plan, "two").status == ImportStatus::not_cut);
    CHECK(says(plan, "level '1' of '1', '2'"));
    CHECK(all<Segment>(*import_drawn(text, {{"storey", "2"}}).map).size() == 6);
  }
  const std::string text = with_wall({on("etage", "EG", 2, "a"), on("etage", "EG", 4, "b"), on("etage", "OG", 6, "c"),
                                      on("etage", "OG", 8, "d")})
                               .dump();
  CHECK(says(import_drawn(text), "doubtful: 'etage' has 2 values"));
  CHECK(says(import_drawn(text, {{"level_property", "etage"}}),
             "'EG' of 'EG', 'OG' (as the property 'etage' says), the first"));
  const nlohmann::json rules{{"type=wall", "Wall"}, {"etage=OG", "Wall"}, {"etage=DG", "Wall"}};
  const MapImport ground = import_drawn(text, {{"level_property", "etage"}, {"storey", "EG"}, {"classes", rules}});
  CHECK(says(ground, "doubtful: no feature is 'etage=DG'"));
  CHECK_FALSE(says(ground, "doubtful: no feature is 'etage=OG'"));
  const MapImport plan = import_drawn(text, {{"level_property", "etage"}, {"storey", "OG"}});
  CHECK(thing(plan, "a").status == ImportStatus::not_cut);
  CHECK(all<Segment>(*plan.map).size() == 6);
  CHECK_THROWS_WITH(import_drawn(text, {{"level_property", "stage"}}), Contains("no feature has the property 'stage'"));
}

TEST_CASE("coordinates that look like degrees are degrees whatever the crs says, and lengths have a unit") {
  const auto in_crs = [](const std::string& crs, double x, double y, double size) {
    json plan{{"type", "FeatureCollection"},
              {"features", {drawn("LineString", {{x, y}, {x + size, y}}, {{"indoor", "wall"}}, "w")}}};
    plan["crs"] = {{"type", "name"}, {"properties", {{"name", crs}}}};
    return plan.dump();
  };
  for (const std::string crs : {"EPSG:4258", "urn:ogc:def:crs:EPSG::4269", "EPSG:31370"})
    CHECK(size_of(import_drawn(in_crs(crs, 5.48, 51.44, 0.0002))).x() == Approx(13.90).margin(0.02));
  CHECK(says(import_drawn(in_crs("EPSG:31370", 5.48, 51.44, 0.0002)), "doubtful: the crs EPSG:31370"));
  const std::string feet = in_crs("EPSG:2263", 0, 0, 32.8084);
  CHECK(says(import_drawn(feet), "doubtful: coordinates in metres: the crs EPSG:2263 is not known"));
  CHECK(size_of(import_drawn(feet, {{"unit", "ft"}})).x() == Approx(10).margin(1e-3));
  CHECK(says(import_drawn(feet, {{"unit", "ft"}}), "coordinates in ft, as the option unit says"));
  CHECK_THROWS_WITH(import_drawn(feet, {{"unit", "feet"}}), Contains("expected one of m, dm, cm, mm, in, ft, yd"));
  CHECK_THROWS_WITH(import_drawn(feet, {{"unit", "ft"}, {"geographic", true}}), Contains("expected one of them"));
}

TEST_CASE("a plan of which no line is long enough gives no map") {
  const json plan{{"type", "FeatureCollection"},
                  {"features", {drawn("LineString", {{0, 0}, {0.0002, 0}}, {{"indoor", "wall"}}, "w")}}};
  CHECK_THROWS_WITH(import_drawn(plan.dump(), {{"geographic", false}}),
                    Contains("plan.geojson: no line is 0.05 m long or longer, expected a building"));
}

TEST_CASE("properties say classes whatever their case, and the report shows one that says something") {
  const MapImport plan =
      import_drawn(with_wall({drawn("LineString", {{0, 2}, {10, 2}}, {{"Area", 169.5}, {"Category", "Wall"}}, "a"),
                              drawn("LineString", {{0, 4}, {10, 4}}, {{"area", 169.5}, {"group", "objects"}}, "b")})
                       .dump());
  CHECK(thing(plan, "a").source_class == "Category=Wall");
  CHECK(thing(plan, "a").status == ImportStatus::imported);
  CHECK(thing(plan, "b").source_class == "group=objects");
}

TEST_CASE("where nothing is known of a feature, the report shows what may say most, and no colour or level") {
  const auto shown = [](json properties) {
    return thing(import_drawn(with_wall({drawn("LineString", {{0, 2}, {10, 2}}, std::move(properties), "x")}).dump()),
                 "x")
        .source_class;
  };
  CHECK(shown({{"color", "#eeeeee"}, {"name", "wall_1"}}) == "name=wall_1");
  CHECK(shown({{"a", "some words"}, {"wtype", "exterior"}}) == "wtype=exterior");
  CHECK(shown({{"fill", "#8442f5"}, {"name", "shop 4"}}) == "name=shop 4");
  CHECK(shown({{"building", "yes"}, {"id", "94551277"}, {"type", "way"}}) == "building=yes");
}

TEST_CASE("the kind of an object may be called its type") {
  const MapImport plan = import_drawn(
      with_wall({drawn("LineString", {{0, 2}, {10, 2}}, {{"objectType", "wall"}, {"level", "0"}}, "x")}).dump());
  CHECK(thing(plan, "x").status == ImportStatus::imported);
}
