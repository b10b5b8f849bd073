#include "room.hpp"

#include "tests/kit/refusal.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <algorithm>

namespace opal::test {
namespace {

const char* const kRoom = R"({
  "@context": ["urn:opal:v1", {"acme": "https://acme.example/#"}],
  "@graph": [
    {"@type": "SemanticMap", "name": "Room"},
    {"@id": "corner-1", "@type": "Point", "x": 0, "y": 0},
    {"@id": "corner-2", "@type": "Point", "x": 8, "y": 0},
    {"@id": "corner-3", "@type": "Point", "x": 8, "y": 5},
    {"@id": "corner-4", "@type": "Point", "x": 0, "y": 5},
    {"@id": "wall-1", "@type": "Wall", "acme:cost": 12, "represented_by": [
      {"@type": "ObjectFeatureRepresentation", "perceivable_by": "PlanarLidar2D",
       "represented_by": {"@id": "face-1", "@type": "LineSegment", "begin": "corner-1", "end": "corner-2"}},
      {"@type": "ObjectFeatureRepresentation", "perceivable_by": "PlanarLidar2D",
       "represented_by": {"@id": "k1", "@type": "Corner", "point": "corner-1", "heading_rad": 0.78539816339744828,
                          "opening_rad": 1.5707963267948966}}]},
    {"@id": "wall-2", "@type": "Wall", "represented_by":
      {"@type": "ObjectFeatureRepresentation", "perceivable_by": "PlanarLidar2D",
       "represented_by": {"@id": "face-2", "@type": "LineSegment", "begin": "corner-2", "end": "corner-3"}}},
    {"@id": "wall-3", "@type": "Wall", "represented_by":
      {"@type": "ObjectFeatureRepresentation", "perceivable_by": "PlanarLidar2D",
       "represented_by": {"@id": "face-3", "@type": "LineSegment", "begin": "corner-3", "end": "corner-4"}}},
    {"@id": "wall-4", "@type": "Wall", "represented_by":
      {"@type": "ObjectFeatureRepresentation", "perceivable_by": "PlanarLidar2D",
       "represented_by": {"@id": "face-4", "@type": "LineSegment", "begin": "corner-4", "end": "corner-1"}}},
    {"@id": "c1", "@type": "Column", "represented_by":
      {"@type": "ObjectFeatureRepresentation", "perceivable_by": "PlanarLidar2D",
       "represented_by": {"@id": "c1/rim", "@type": "Circle", "center": {"@type": "Point", "x": 3, "y": 2},
                          "radius_m": 0.2}}},
    {"@id": "pair", "@type": "FeaturePattern", "template": "opal:ColumnPair", "features": ["face-1", "c1/rim"],
     "dimensions": [2]},
    {"@id": "whole", "@type": "FeaturePattern", "template": "opal:Whole", "features": ["face-3", "face-1"],
     "subpatterns": ["pair"]}]})";

template <class Element>
const Element& with_id(const std::vector<Element>& elements, const std::string& id) {
  const auto found = std::find_if(elements.begin(), elements.end(), [&](const Element& one) { return one.id == id; });
  INFO("no element '" << id << "'");
  REQUIRE(found != elements.end());
  return *found;
}

}  // namespace

std::shared_ptr<const SemanticMap> room() { return SemanticMap::parse(kRoom, "room.jsonld"); }

MapOverlay overlay(const std::string& changes, const std::string& nodes, const std::string& name) {
  return parse_overlay(R"({"@context": ["urn:opal:v1", {"acme": "https://acme.example/#"}], "@graph": [
    {"@type": "MapOverlay", "changes": [)" +
                           changes + "]}" + (nodes.empty() ? "" : ", " + nodes) + "]}",
                       name);
}

OverlaidMap overlaid(const SemanticMap& map, const MapOverlay& overlay) { return overlaid_map(map, {overlay}); }

const MapFeature& feature(const SemanticMap& map, const std::string& id) { return with_id(map.features(), id); }
const MapObject& object(const SemanticMap& map, const std::string& id) { return with_id(map.objects(), id); }

bool has_feature(const SemanticMap& map, const std::string& id) {
  return std::any_of(map.features().begin(), map.features().end(), [&](const MapFeature& one) { return one.id == id; });
}

std::string refusal(const SemanticMap& map, const std::vector<MapOverlay>& overlays) {
  return refused_with<MapError>([&] { overlaid_map(map, overlays); });
}

std::string all_of(const std::vector<std::string>& sentences) {
  std::string all;
  for (const std::string& sentence : sentences) all += sentence + "\n";
  return all;
}

}  // namespace opal::test
