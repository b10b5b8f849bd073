// What overlays do to a map, and what they are refused for.
#include "room.hpp"

#include <opal/common/error.hpp>
#include "map/check/map_check.hpp"

#include <catch2/catch.hpp>

#include <numbers>

namespace {

using namespace opal;
using namespace opal::test;
using Catch::Contains;

constexpr double kPi = std::numbers::pi;

Segment face(const SemanticMap& map, const std::string& id) { return std::get<Segment>(feature(map, id).geometry); }

}  // namespace

TEST_CASE("features are disabled by their perceivable-by relation, and enabled again") {
  const OverlaidMap off =
      overlaid(*room(), overlay(R"({"target": "face-2", "not_perceivable_by": "PlanarLidar2D", "because": "glass"})"));
  CHECK(feature(*off.map, "face-2").sensor.empty());
  CHECK(feature(*off.map, "face-1").sensor == "PlanarLidar2D");
  CHECK(off.map->features().size() == room()->features().size());
  CHECK(all_of(off.changes) == "face-2: 1 feature no longer perceivable by PlanarLidar2D, because glass\n");
  CHECK(off.doubts.empty());
  const OverlaidMap on = overlaid(*off.map, overlay(R"({"target": "face-2", "perceivable_by": "PlanarLidar2D"})"));
  CHECK(on.map->to_json_ld() == room()->to_json_ld());
}

TEST_CASE("a whole object is disabled, with its corner, and told what else leans on it") {
  const OverlaidMap off = overlaid(*room(), overlay(R"({"target": "wall-1", "not_perceivable_by": "PlanarLidar2D"})"));
  CHECK(feature(*off.map, "face-1").sensor.empty());
  CHECK(feature(*off.map, "k1").sensor.empty());
  CHECK(object(*off.map, "wall-1").type == "opal:Wall");
  const OverlaidMap other =
      overlaid(*room(), overlay(R"({"target": "wall-4", "not_perceivable_by": "PlanarLidar2D"})"));
  CHECK_THAT(all_of(other.doubts), Contains("k1: is still perceivable by PlanarLidar2D, but 'face-4'"));
}

TEST_CASE("a feature is enabled for another sensor beside its own") {
  const OverlaidMap both = overlaid(*room(), overlay(R"({"target": "c1", "perceivable_by": "Camera"},
                                                         {"target": "c1/rim", "existence": 0.5})"));
  REQUIRE(both.map->features().size() == room()->features().size() + 1);
  int seen = 0;
  for (const MapFeature& one : both.map->features())
    if (one.id == "c1/rim" && one.existence == 0.5) ++seen;
  CHECK(seen == 2);
}

TEST_CASE("a shared point takes all its faces along, and corners turn with them") {
  const OverlaidMap moved = overlaid(*room(), overlay(R"({"target": "corner-4", "x": 1, "y": 6})"));
  CHECK(face(*moved.map, "face-3").end == Point(1, 6));
  CHECK(face(*moved.map, "face-4").begin == Point(1, 6));
  const auto corner = std::get<OrientedPoint>(feature(*moved.map, "k1").geometry);
  CHECK(corner.position == Point(0, 0));
  CHECK(corner.opening_rad == Approx(std::atan2(6, 1)));
  CHECK(corner.heading_rad == Approx(std::atan2(6, 1) / 2));
  CHECK_THAT(all_of(moved.changes), Contains("k1: turned with the faces") && Contains("corner-4: x 0 -> 1; y 5 -> 6"));
  CHECK(moved.doubts.empty());
}

TEST_CASE("a corner that its faces never made is not turned, but told") {
  const auto odd = overlaid(*room(), overlay(R"({"target": "k1", "heading_rad": 2})")).map;
  const OverlaidMap moved = overlaid(*odd, overlay(R"({"target": "corner-4", "x": 1})"));
  CHECK(std::get<OrientedPoint>(feature(*moved.map, "k1").geometry).heading_rad == 2);
  CHECK_THAT(all_of(moved.doubts), Contains("k1: faces that meet in it have turned"));
  const OverlaidMap said =
      overlaid(*odd, overlay(R"({"target": "corner-4", "x": 1}, {"target": "k1", "heading_rad": 1.5})"));
  CHECK(std::get<OrientedPoint>(feature(*said.map, "k1").geometry).heading_rad == 1.5);
  CHECK(said.doubts.empty());
}

TEST_CASE("a geometry with one point is moved by its own id") {
  const OverlaidMap moved = overlaid(*room(), overlay(R"({"target": "c1/rim", "x": 4, "radius_m": 0.3})"));
  const auto circle = std::get<Circle>(feature(*moved.map, "c1/rim").geometry);
  CHECK(circle.center == Point(4, 2));
  CHECK(circle.radius_m == 0.3);
  CHECK_THAT(refusal(*room(), {overlay(R"({"target": "face-1", "x": 1})")}),
             Contains("'face-1' has no x, expected a point"));
}

TEST_CASE("types and qualities are set, of a feature or of all of an object") {
  const OverlaidMap set = overlaid(*room(), overlay(R"(
    {"target": "wall-1", "object_type": "acme:Shelf", "existence": 0.5, "position_sigma_m": 0.2},
    {"target": "face-2", "feature_type": "acme:Glass"})"));
  CHECK(object(*set.map, "wall-1").type == "acme:Shelf");
  CHECK(feature(*set.map, "face-1").existence == 0.5);
  CHECK(feature(*set.map, "k1").position_sigma_m == 0.2);
  CHECK(feature(*set.map, "face-2").type == "acme:Glass");
  CHECK(set.map->prefixes().at("acme") == "https://acme.example/#");
  CHECK(set.map->unused() == room()->unused());
}

TEST_CASE("objects and features are added, and may use points of the map") {
  const OverlaidMap added = overlaid(*room(), overlay("", R"(
    {"@id": "kiosk", "@type": "acme:Kiosk", "acme:opens": 9, "represented_by": {"@type": "ObjectFeatureRepresentation",
      "perceivable_by": "PlanarLidar2D", "represented_by": {"@id": "kiosk/face", "@type": "LineSegment",
        "begin": "corner-3", "end": {"@id": "kiosk/post", "@type": "Point", "x": 6, "y": 3}}}},
    {"@id": "wall-2", "@type": "Wall", "represented_by": {"@type": "ObjectFeatureRepresentation",
      "perceivable_by": "PlanarLidar2D", "represented_by": {"@id": "face-2/niche", "@type": "LineSegment",
        "begin": {"@type": "Point", "x": 8, "y": 2}, "end": {"@type": "Point", "x": 8.5, "y": 2}}}})"));
  CHECK(object(*added.map, "kiosk").type == "acme:Kiosk");
  CHECK(face(*added.map, "kiosk/face").begin == Point(8, 5));
  CHECK(feature(*added.map, "kiosk/face").points.front() == "corner-3");
  CHECK(object(*added.map, "wall-2").features.size() == 2);
  CHECK(added.map->unused().size() == room()->unused().size() + 1);
  CHECK_THAT(all_of(added.changes),
             Contains("kiosk: added, acme:Kiosk") && Contains("face-2/niche: added to 'wall-2'"));
}

TEST_CASE("what is added may be changed by another overlay, whichever comes first") {
  const MapOverlay kiosk = overlay("", R"({"@id": "kiosk", "@type": "acme:Kiosk", "represented_by": {
      "@type": "ObjectFeatureRepresentation", "perceivable_by": "PlanarLidar2D", "represented_by": {"@id": "kiosk/rim",
        "@type": "Circle", "center": {"@type": "Point", "x": 5, "y": 2}, "radius_m": 0.4}}})",
                                   "kiosk.jsonld");
  const MapOverlay moved = overlay(R"({"target": "kiosk/rim", "x": 6}, {"target": "kiosk", "object_type": "acme:Stand"},
                                      {"target": "kiosk", "not_perceivable_by": "PlanarLidar2D"})",
                                   "", "moved.jsonld");
  const OverlaidMap one = overlaid_map(*room(), {kiosk, moved}), two = overlaid_map(*room(), {moved, kiosk});
  CHECK(one.map->to_json_ld() == two.map->to_json_ld());
  CHECK(one.changes == two.changes);
  CHECK(overlaid_map(*one.map, {kiosk, moved}).map->to_json_ld() == one.map->to_json_ld());
}

TEST_CASE("what the map no longer has is an error by id, or told") {
  const std::string changes =
      R"({"target": "wall-9", "existence": 0, "because": "demolished"}, {"target": "face-1", "existence": 0.5})";
  const std::string message =
      refusal(*room(), {overlay(changes), overlay(R"({"target": "corner-7", "x": 1})", "", "b.jsonld")});
  CHECK_THAT(message, Contains("room.overlay.jsonld: /@graph/0/changes/0: 'wall-9', because demolished") &&
                          Contains("b.jsonld: /@graph/0/changes/0: 'corner-7'"));
  OverlayOptions lenient;
  lenient.report_missing = true;
  const OverlaidMap told = overlaid_map(*room(), {overlay(changes)}, lenient);
  CHECK(feature(*told.map, "face-1").existence == 0.5);
  CHECK_THAT(all_of(told.doubts), Contains("wall-9: the map does not have it") && Contains("because demolished"));
  const OverlaidMap willing =
      overlaid(*room(), overlay(R"({"target": "wall-9", "existence": 0, "if_missing": "report"})"));
  CHECK(willing.doubts == std::vector<std::string>{told.doubts[0].substr(0, told.doubts[0].find(", because"))});
}

TEST_CASE("a map that says something else than when the change was written is told") {
  const MapOverlay change = overlay(R"({"target": "corner-2", "x": 8.2, "was": {"x": 8}})");
  CHECK(overlaid(*room(), change).doubts.empty());
  const auto rebuilt = overlaid(*room(), overlay(R"({"target": "corner-2", "x": 9})")).map;
  CHECK_THAT(all_of(overlaid(*rebuilt, change).doubts), Contains("corner-2: x is 9 in the map, but was 8"));
  CHECK(overlaid(*overlaid(*room(), change).map, change).doubts.empty());
}

TEST_CASE("a sensor that perceives nothing of the target is told") {
  const OverlaidMap typo = overlaid(*room(), overlay(R"({"target": "wall-1", "not_perceivable_by": "PlanarLidar"})"));
  CHECK_THAT(all_of(typo.doubts), Contains("wall-1: is not perceivable by PlanarLidar but by PlanarLidar2D"));
}

TEST_CASE("contradicting changes are an error that names both places, in any order") {
  const auto contradict = [](const std::string& a, const std::string& b) {
    const MapOverlay first = overlay(a, "", "a.jsonld"), second = overlay(b, "", "b.jsonld");
    const std::string message = refusal(*room(), {first, second});
    CHECK_THAT(message, Contains("a.jsonld: /@graph/0/changes/0") && Contains("b.jsonld: /@graph/0/changes/0"));
    CHECK(message == refusal(*room(), {second, first}));
  };
  contradict(R"({"target": "corner-2", "x": 8.1})", R"({"target": "corner-2", "x": 8.2})");
  contradict(R"({"target": "wall-1", "existence": 0.1})", R"({"target": "face-1", "existence": 0.2})");
  contradict(R"({"target": "wall-1", "object_type": "Column"})", R"({"target": "wall-1", "object_type": "Door"})");
  contradict(R"({"target": "c1", "perceivable_by": "PlanarLidar2D"})",
             R"({"target": "c1/rim", "not_perceivable_by": "PlanarLidar2D"})");
  contradict(R"({"target": "k1", "x": 1})", R"({"target": "corner-1", "x": 2})");
  CHECK(refusal(*room(), {overlay(R"({"target": "corner-2", "x": 8.1})"),
                          overlay(R"({"target": "corner-2", "x": 8.1, "y": 1})")}) == "accepted");
}

TEST_CASE("changes that mean nothing for their target are errors") {
  const auto refused = [](const std::string& change) { return refusal(*room(), {overlay(change)}); };
  CHECK_THAT(refused(R"({"target": "wall-1", "x": 1})"), Contains("'wall-1' has no x"));
  CHECK_THAT(refused(R"({"target": "face-1", "radius_m": 1})"), Contains("'face-1' has no radius_m"));
  CHECK_THAT(refused(R"({"target": "corner-1", "existence": 1})"), Contains("'corner-1' has no existence"));
  CHECK_THAT(refused(R"({"target": "face-1", "object_type": "Wall"})"), Contains("'face-1' has no object_type"));
  CHECK_THAT(refused(R"({"target": "corner-1", "feature_type": "Wall"})"), Contains("'corner-1' has no feature_type"));
  CHECK_THAT(refused(R"({"target": "corner-1", "perceivable_by": "Camera"})"),
             Contains("nothing that a sensor perceives"));
  CHECK_THAT(refused(R"({"target": "face-1", "existence": 1.5})"),
             Contains("existence is 1.5, expected a probability"));
  CHECK_THAT(refused(R"({"target": "corner-1", "x": 1e9})"), Contains("at most 1e6"));
  CHECK_THAT(refused(R"({"target": "corner-2", "x": 0})"), Contains("face-1"));  // no length is left
}

TEST_CASE("additions that the map has otherwise, or that are no map, are errors") {
  const auto refused = [](const std::string& node) { return refusal(*room(), {overlay("", node)}); };
  CHECK_THAT(refused(R"({"@id": "wall-1", "@type": "Column"})"),
             Contains("object 'wall-1' is opal:Column, but the map has it as opal:Wall"));
  CHECK_THAT(refused(R"({"@id": "c1", "@type": "Column", "represented_by": {"@type": "ObjectFeatureRepresentation",
      "perceivable_by": "PlanarLidar2D", "represented_by": {"@id": "c1/rim", "@type": "Circle",
        "center": {"@type": "Point", "x": 3, "y": 2}, "radius_m": 0.5}}})"),
             Contains("the map has another 'c1/rim'"));
  CHECK_THAT(refused(R"({"@id": "d", "@type": "Wall", "represented_by": {"@type": "ObjectFeatureRepresentation",
      "represented_by": {"@id": "d/face", "@type": "LineSegment", "begin": "corner-9", "end": "corner-1"}}})"),
             Contains("refers to 'corner-9'"));
}

TEST_CASE("patterns follow their members") {
  const OverlaidMap moved = overlaid(*room(), overlay(R"({"target": "c1/rim", "y": 2.5})"));
  REQUIRE(moved.map->patterns().size() == 2);
  CHECK(moved.map->patterns()[0].dimensions.empty());
  CHECK_THAT(all_of(moved.changes), Contains("pair: pattern without the dimensions"));
  const OverlaidMap off = overlaid(*room(), overlay(R"({"target": "c1", "not_perceivable_by": "PlanarLidar2D"})"));
  CHECK(off.map->patterns().empty());
  CHECK_THAT(all_of(off.changes), Contains("pair: pattern left out, as its member 'c1/rim'") &&
                                      Contains("whole: pattern left out, as its part 'pair' is"));
  const OverlaidMap other = overlaid(*room(), overlay(R"({"target": "face-4", "existence": 0.5})"));
  CHECK(other.map->patterns().size() == 2);
  CHECK(other.map->feature(other.map->patterns()[0].features[1]).id == "c1/rim");
}
