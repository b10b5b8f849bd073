#include "import_source.hpp"

#include <opal/common/error.hpp>
#include "map/check/map_check.hpp"
#include "tests/kit/refusal.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;
using nlohmann::json;

namespace {

json feature(const std::string& type, const json& coordinates, json properties = json::object(),
             const std::string& id = "") {
  json made{{"type", "Feature"},
            {"geometry", {{"type", type}, {"coordinates", coordinates}}},
            {"properties", std::move(properties)}};
  if (!id.empty()) made["id"] = id;
  return made;
}

json collection(const std::vector<json>& features) { return {{"type", "FeatureCollection"}, {"features", features}}; }

json box(double x0, double y0, double x1, double y1) {
  return json::array({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}});
}

const json kWall{{"indoor", "wall"}};

MapImport import_geojson(const json& document, const json& options = json::object()) {
  return import_text("geojson_importer", "opal:GeoJsonImporter", "plan.geojson", document.dump(), options);
}

json drawn_circle(const Point& centre, double radius, int corners) {
  json ring = json::array();
  for (int k = 0; k <= corners; ++k) {
    const Point p = centre + radius * unit_vector(2 * std::numbers::pi * (k % corners) / corners);
    ring.push_back({p.x(), p.y()});
  }
  return ring;
}

}  // namespace

TEST_CASE("areas are massive, lines are seen from both sides, points with a radius are columns") {
  const MapImport plan = import_geojson(collection({
      feature("Polygon", json::array({box(0, 0, 8, 6), box(0.3, 0.3, 7.7, 5.7)}), kWall, "shell"),
      feature("LineString", {{4, 0.3}, {4, 3}}, kWall, "screen"),
      feature("Point", {2, 2}, {{"class", "column"}, {"radius_m", 0.2}}, "c1"),
      feature("Polygon", json::array({drawn_circle({6, 4}, 0.15, 24)}), {{"class", "Column"}}, "c2"),
      feature("MultiPolygon", json::array({json::array({box(1, 4, 1.3, 4.3)}), json::array({box(2, 4, 2.3, 4.3)})}),
              {{"class", "pillar"}}, "c3"),
      feature("LineString", {{0, 0}, {1, 0}}, {{"indoor", "kiosk"}}, "room"),
  }));
  CHECK(has_face(*plan.map, {8, 0}, {0, 0}));
  CHECK(has_face(*plan.map, {0.3, 0.3}, {4, 0.3}));  // cut where the screen meets it
  CHECK(has_face(*plan.map, {4, 0.3}, {4, 3}));
  CHECK(has_face(*plan.map, {4, 3}, {4, 0.3}));
  CHECK(all<Circle>(*plan.map).size() == 2);
  CHECK(all<Segment>(*plan.map).size() == 4 + 5 + 2 + 8);
  CHECK(thing(plan, "room").status == ImportStatus::left_out);
  CHECK(thing(plan, "room").source_class == "indoor=kiosk");
  CHECK(says(plan, "circles that were drawn as polygons: 1"));
  CHECK(says(plan, "coordinates in metres"));
}

TEST_CASE("a class can be in any property, and rules are the deployment's") {
  const json document =
      collection({feature("Polygon", json::array({box(0, 0, 5, 0.2)}), {{"Kategorie", "Mauer"}}, "m")});
  CHECK_THROWS_WITH(import_geojson(document),
                    Contains("no feature gives anything") && Contains("'Kategorie=Mauer' (1 Polygon)"));
  CHECK(all<Segment>(*import_geojson(document, {{"classes", {{"Kategorie=Mauer", "Wall"}}}}).map).size() == 4);
  const MapImport kiosk = import_geojson(
      document, {{"class_property", "Kategorie"}, {"classes", {{"mau*", "opal:Kiosk"}}}, {"perceivable", "Kiosk"}});
  CHECK(kiosk.map->objects().front().type == "opal:Kiosk");
  CHECK(all<Segment>(*kiosk.map).size() == 4);
}

TEST_CASE("degrees are projected as RFC 7946 has them, and metres are known by their extent") {
  const json degrees = collection({feature("Polygon", json::array({box(5.48, 51.44, 5.4802, 51.4401)}), kWall, "w")});
  const MapImport plan = import_geojson(degrees);
  const MapCheck check = check_map(*plan.map);
  CHECK(check.bounds[1].x() - check.bounds[0].x() == Approx(13.90).margin(0.02));  // 0.0002 degrees of longitude
  CHECK(check.bounds[1].y() - check.bounds[0].y() == Approx(11.12).margin(0.02));
  CHECK(check.bounds[0].x() == Approx(-check.bounds[1].x()));
  CHECK(says(plan, "WGS 84"));
  const MapImport elsewhere =
      import_geojson(degrees, {{"geographic", true}, {"origin_lon_deg", 5.48}, {"origin_lat_deg", 51.44}});
  CHECK(check_map(*elsewhere.map).bounds[0].norm() == Approx(0).margin(1e-6));
  CHECK_THROWS_WITH(import_geojson(degrees, {{"geographic", true}, {"origin_lon_deg", 5.48}}),
                    Contains("expected both or none"));
  const json metres = collection({feature("Polygon", json::array({box(0, 0, 500, 300)}), kWall)});
  CHECK_THROWS_WITH(import_geojson(metres, {{"geographic", true}}), Contains("no longitude and latitude"));
  CHECK_NOTHROW(import_geojson(metres));
}

TEST_CASE("a plan in degrees can take the origin of another plan, which is in degrees, too") {
  const TemporaryFolder folder;
  const auto plan_in = [&](const std::string& name, const json& ring) {
    return folder.write(name, collection({feature("Polygon", json::array({ring}), kWall, "w")}).dump());
  };
  const std::string ground = plan_in("ground.geojson", box(5.48, 51.44, 5.4802, 51.4401));
  const std::string metres = plan_in("metres.geojson", box(0, 0, 500, 300));
  const json upper = collection({feature("Polygon", json::array({box(5.4801, 51.44, 5.4802, 51.4401)}), kWall, "w")});
  CHECK(check_map(*import_geojson(upper, {{"origin_file", ground}}).map).bounds[0].x() == Approx(0).margin(1e-3));
  CHECK_THROWS_WITH(import_geojson(upper, {{"origin_file", metres}}),
                    Contains("metres.geojson: holds no longitude and latitude, expected a plan in degrees"));
}

TEST_CASE("one level is imported, the nearest to the ground unless another is named") {
  const auto wall = [](double y, const json& level, const std::string& id) {
    json made = feature("LineString", {{0, y}, {5, y}}, kWall, id);
    if (!level.is_null()) made["properties"]["level"] = level;
    return made;
  };
  const json document =
      collection({wall(0, "0;1", "both"), wall(1, 1, "first"), wall(2, "-1-0", "below"), wall(3, nullptr, "any")});
  const MapImport ground = import_geojson(document);
  CHECK(says(ground, "level '0' of '-1', '0', '1', the nearest to the ground"));
  CHECK(thing(ground, "first").status == ImportStatus::not_cut);
  const MapImport first = import_geojson(document, {{"storey", "1"}});
  CHECK(all<Segment>(*first.map).size() == 6);
  CHECK(thing(first, "below").status == ImportStatus::not_cut);
  CHECK(all<Segment>(*import_geojson(document, {{"storey", "-1"}}).map).size() == 4);
  CHECK_THROWS_WITH(import_geojson(document, {{"storey", "7"}}),
                    Contains("has no level '7', expected one of '-1', '0', '1'"));
}

TEST_CASE("what is no GeoJSON is refused with file and place") {
  const auto refusal = [](const std::string& text) {
    return refused_with<MapError>(
        [&] { import_text("geojson_importer", "opal:GeoJsonImporter", "plan.geojson", text); });
  };
  const auto with = [&](json changed) { return refusal(collection(std::vector<json>{std::move(changed)}).dump()); };
  CHECK_THAT(refusal(""), Contains("plan.geojson"));
  CHECK_THAT(refusal("{\"type\": \"FeatureCollection\", \"type\": 3}"), Contains("plan.geojson"));
  CHECK_THAT(refusal("{\"type\": \"Topology\"}"),
             Contains("/type: \"Topology\", expected FeatureCollection or Feature"));
  CHECK_THAT(with(feature("Polygon", json::array({json::array({{0, 0}, {1, 0}})}), kWall)),
             Contains("/features/0/geometry/coordinates/0: [[0,0],[1,0]], expected at least 4 positions"));
  CHECK_THAT(with(feature("Polygon", json::array({json::array({{0, 0}, {1, 0}, {0, 0}})}), kWall)),
             Contains("expected at least 4 positions"));
  CHECK_THAT(with(feature("LineString", {{0, 0}, {1, "x"}}, kWall)),
             Contains("/coordinates/1: [1,\"x\"], expected a position"));
  CHECK_THAT(with(feature("Circle", {0, 0}, kWall)),
             Contains("/features/0/geometry/type: \"Circle\", expected a geometry of RFC 7946"));
  CHECK_THAT(with({{"type", "Feature"}, {"properties", kWall}}), Contains("/features/0: no geometry"));
  CHECK_THAT(with(feature("LineString", {{0, 0}, {1e300, 0}}, kWall)), Contains("within 1e6 m of the origin"));
}

TEST_CASE("features without geometry or radius are reported, not lost") {
  json nothing = feature("Point", {0, 0}, kWall, "nothing");
  nothing["geometry"] = nullptr;
  const MapImport plan = import_geojson(collection({feature("LineString", {{0, 0}, {5, 0}}, kWall, "w"), nothing,
                                                    feature("Point", {1, 1}, {{"class", "column"}}, "p")}));
  CHECK(thing(plan, "nothing").reason == "it has no geometry");
  CHECK(thing(plan, "p").reason == "a point without a positive radius_m");
}
