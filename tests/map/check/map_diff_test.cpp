#include "map/check/map_diff.hpp"

#include <catch2/catch.hpp>

#include <functional>

using namespace opal;

namespace {

struct Parts {
  std::string name = "hall";
  std::vector<MapObject> objects{{"w1", "opal:Wall"}, {"w2", "opal:Wall"}};
  std::vector<MapFeature> features;
  std::vector<MapPattern> patterns{{"p1", "acme:Pair", {MapFeatureNumber(0), MapFeatureNumber(1)}}};
  MapOrigin origin;
};

Parts parts() {
  Parts made;
  const std::vector<Geometry> geometries{Segment{{0, 0}, {4, 0}}, Circle{{2, 2}, 0.3}, OrientedPoint{{0, 0}, 0.5, 1.5},
                                         Point(7, 7)};
  for (const Geometry& geometry : geometries) {
    MapFeature feature;
    feature.id = "f" + std::to_string(made.features.size());
    feature.object = MapObjectNumber(made.features.size() % 2);
    feature.sensor = "lidar";
    feature.geometry = geometry;
    made.features.push_back(feature);
  }
  made.origin.placements = {{"source", {1, 2, 0.5}}};
  return made;
}

std::shared_ptr<const SemanticMap> made(const Parts& p) {
  return SemanticMap::make(p.name, p.objects, p.features, p.patterns, p.origin);
}

MapDiff diff_after(const std::function<void(Parts&)>& change) {
  Parts changed = parts();
  change(changed);
  return map_diff(*made(parts()), *made(changed));
}

}  // namespace

TEST_CASE("equal maps do not differ, however they were made") {
  CHECK(diff_after([](Parts&) {}).empty());
  CHECK(diff_after([](Parts&) {}).sentences().empty());
  CHECK(diff_after([](Parts& p) {
          std::swap(p.objects[0], p.objects[1]);
          for (MapFeature& feature : p.features) feature.object = MapObjectNumber(1 - feature.object.number());
        }).empty());
}

TEST_CASE("maps do not differ if and only if their documents are equal") {
  const std::vector<std::function<void(Parts&)>> changes{
      // clang-format off
      [](Parts& p) { p.name = "other"; },
      [](Parts& p) { p.origin.smear_m = 0.1; },
      [](Parts& p) { p.origin.placements[0].T_map_source = {1, 2.5, 0.5}; },
      [](Parts& p) { p.origin.placements[0].scale = {-1, 1}; },
      [](Parts& p) { p.origin.placements.clear(); },
      [](Parts& p) { p.origin.cut_height_m = 0.3; },
      [](Parts& p) { p.origin.storey = "Level 1"; },
      [](Parts& p) { p.origin.widest_door_m = 1; },
      [](Parts& p) { p.origin.north_rad = 0; },
      [](Parts& p) { p.origin.georeference = Georeference{"EPSG:28992", 1, 2, 3, 4}; },
      [](Parts& p) { p.objects[0].notes.name = "north"; },
      [](Parts& p) { p.objects[0].notes.source_class = "IfcWall"; },
      [](Parts& p) { p.objects[0].notes.storey = "Level 1"; },
      [](Parts& p) { p.objects[0].notes.thickness_m = 0.1; },
      [](Parts& p) { p.objects[0].notes.width_m = 0.9; },
      [](Parts& p) { p.objects[0].notes.axis = Segment{{0, 0}, {4, 0}}; },
      [](Parts& p) { p.objects[0].notes.merged_ids = {"other"}; },
      [](Parts& p) { p.objects[0].type = "opal:Door"; },
      [](Parts& p) { p.objects.push_back({"w3", "opal:Wall"}); },
      [](Parts& p) { p.features[0].type = "acme:Edge"; },
      [](Parts& p) { p.features[0].sensor = "camera"; p.features[1].sensor = "camera"; },
      [](Parts& p) { p.features[0].object = MapObjectNumber(1); },
      [](Parts& p) { p.features[0].position_sigma_m = 0.1; },
      [](Parts& p) { p.features[0].existence = 0.5; },
      [](Parts& p) { p.features[0].points = {"a", "b"}; },
      [](Parts& p) { p.features[0].representation = "r"; },
      [](Parts& p) { p.features[0].geometry = Segment{{0, 0}, {4, 1e-15}}; },
      [](Parts& p) { p.features[0].geometry = Circle{{0, 0}, 1}; },
      [](Parts& p) { p.features[1].geometry = Circle{{2, 2}, 0.31}; },
      [](Parts& p) { p.features[2].geometry = OrientedPoint{{0, 0}, 0.6, 1.5}; },
      [](Parts& p) { p.features[2].geometry = OrientedPoint{{0, 0}, 0.5, 1.6}; },
      [](Parts& p) { p.features[3].geometry = Point(7, 7.5); },
      [](Parts& p) { p.features.pop_back(); },
      [](Parts& p) { p.patterns[0].pattern_template = "acme:Other"; },
      [](Parts& p) { p.patterns[0].features = {MapFeatureNumber(1), MapFeatureNumber(0)}; },
      [](Parts& p) { p.patterns[0].dimensions = {0.1}; },
      [](Parts& p) { p.patterns.push_back({"p2", "acme:Pair", {MapFeatureNumber(2), MapFeatureNumber(3)}, {"p1"}}); },
      [](Parts& p) { p.patterns.clear(); },
      // clang-format on
  };
  for (std::size_t k = 0; k < changes.size(); ++k) {
    CAPTURE(k);
    Parts changed = parts();
    changes[k](changed);
    const auto before = made(parts()), after = made(changed);
    REQUIRE(before->to_json_ld() != after->to_json_ld());
    CHECK_FALSE(map_diff(*before, *after).empty());
    CHECK_FALSE(map_diff(*after, *before).empty());
    CHECK_FALSE(map_diff(*before, *after).sentences().empty());
    CHECK(map_diff(*after, *after).empty());
  }
}

TEST_CASE("what is said in other vocabularies, and prefixes, are part of a map") {
  const auto map = [](const std::string& prefix, int price) {
    return SemanticMap::parse(R"({"@context": ["urn:opal:v1", {")" + prefix +
                                  R"(": "urn:acme:"}], "@graph": [{"@id": "w", "@type": "Wall", ")" + prefix +
                                  R"(:price": )" + std::to_string(price) + "}]}",
                              "hall");
  };
  CHECK(map_diff(*map("acme", 1), *map("acme", 1)).empty());
  CHECK(map_diff(*map("acme", 1), *map("acme", 2)).sentences().front() == "map: 1 altered");
  CHECK(map_diff(*map("acme", 1), *map("ac", 1)).sentences().back() == "map altered: other prefixes of names");
}

TEST_CASE("a diff says how far things moved, and in which ways they differ") {
  const MapDiff diff = diff_after([](Parts& p) {
    p.features[0].geometry = Segment{{0, 0.3}, {4, -0.4}};
    p.features[1].geometry = Circle{{2, 2.1}, 0.25};
    p.features[1].type = "acme:Pillar";
    p.features[3].id = "f9";
    p.objects[1].type = "opal:Door";
  });
  CHECK(diff.sentences() == std::vector<std::string>{
                                "objects: 1 re-typed",
                                "features: 1 added, 1 removed, 2 moved (by at most 0.400 m), 1 re-typed, 1 altered",
                                "object w2 re-typed: opal:Wall, now opal:Door",
                                "feature f0 moved by 0.400 m",
                                "feature f1 re-typed: opal:Column, now acme:Pillar",
                                "feature f1 moved by 0.100 m",
                                "feature f1 altered: radius_m 0.3, now 0.25",
                                "feature f9 added: opal:Point of w2, perceivable by lidar",
                                "feature f3 removed: opal:Point of w2, perceivable by lidar",
                            });
}

TEST_CASE("a feature that is switched off for a sensor is removed for it and added for none") {
  const MapDiff diff = diff_after([](Parts& p) { p.features[3].sensor.clear(); });
  REQUIRE(diff.changes.size() == 2);
  CHECK(diff.changes[0].kind == ChangeKind::added);
  CHECK(diff.changes[0].detail == "opal:Point of w2, perceivable by none");
  CHECK(diff.changes[1].kind == ChangeKind::removed);
  CHECK(diff.changes[1].id == "f3");
}
