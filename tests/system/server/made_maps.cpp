#include "made_maps.hpp"

#include <opal/map/map_importer.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace opal::store_tests {
namespace {

constexpr const char* kRichDocument = R"json({
  "@context": ["urn:opal:v1", { "acme": "https://acme.example/types#", "other": "urn:other:" }],
  "@graph": [
    { "@type": "SemanticMap", "name": "It's \"rich\": \\ \u00e9 \u4e2d $1 %s", "smear_m": 0.04, "storey": "Level 1", "cut_height_m": 0.3, "crs": "EPSG:28992", "eastings_m": 1.5, "northings_m": 2 },
    { "@id": "hall", "@type": "MapPlacement", "x": 1.5, "y": -2, "heading_rad": 0.25, "scale_x": -1, "scale_y": 1.0000000000000002 },
    { "@id": "storey-1", "@type": "Storey", "name": "Level 1", "has_element": [{ "@id": "w1" }, { "@id": "k'1" }] },
    { "@id": "w1", "@type": ["Wall", "acme:FireWall"], "name": "a wall", "source_class": "IfcWall", "merged_ids": ["w9", "k'1"], "axis": [0, 0.1, 8, 0.1], "acme:thickness": 0.1, "acme:rating": { "@value": "F90", "@language": "de" },
      "acme:next": [{ "@id": "k'1" }, { "@id": "acme:Nowhere" }], "acme:steps": { "@list": [1, 2, { "@id": "w1" }] },
      "represented_by": [
        { "@id": "r1", "@type": "ObjectFeatureRepresentation", "perceivable_by": { "@id": "PlanarLidar2D" }, "acme:made_by": "hand",
          "represented_by": { "@id": "s1", "@type": "LineSegment", "position_sigma_m": 1e-7, "acme:colour": "red",
            "begin": { "@id": "p1", "@type": "Point", "x": 0.1, "y": 0.2 }, "end": { "@id": "p2", "@type": "Point", "x": 8.000000000000002, "y": -3.3e-17 } } },
        { "@type": "ObjectFeatureRepresentation", "perceivable_by": { "@id": "acme:Camera" }, "represented_by": { "@id": "s1" } },
        { "@type": "ObjectFeatureRepresentation", "represented_by": { "@id": "s2", "@type": "LineSegment", "begin": { "@id": "p2" }, "end": { "@id": "p1" } } } ] },
    { "@id": "k'1", "@type": "acme:Kiosk",
      "represented_by": [
        { "@type": "ObjectFeatureRepresentation", "perceivable_by": { "@id": "PlanarLidar2D" }, "feature_type": "acme:Edge", "existence": 0.3333333333333333,
          "represented_by": { "@id": "k", "@type": "Corner", "point": { "@id": "p2" }, "heading_rad": -3.141592653589793, "opening_rad": 4.71238898038469 } },
        { "@type": "ObjectFeatureRepresentation", "perceivable_by": { "@id": "PlanarLidar2D" },
          "represented_by": { "@id": "other:c", "@type": "Circle", "center": { "@id": "p3", "@type": "Point", "x": 123456.789, "y": 2 }, "radius_m": 0.15 } },
        { "@type": "ObjectFeatureRepresentation", "perceivable_by": { "@id": "PlanarLidar2D" },
          "represented_by": { "@id": "o", "@type": "Point", "x": -1e-30, "y": 3 } } ] },
    { "@id": "d", "@type": "Door" },
    { "@id": "x", "@type": ["acme:Thing", "Element"] },
    { "@id": "unused-circle", "@type": "Circle", "center": { "@id": "p3" }, "radius_m": 2 },
    { "@id": "pair", "@type": "FeaturePattern", "template": "acme:Pair", "perceivable_by": { "@id": "PlanarLidar2D" },
      "features": ["s1", "other:c"], "dimensions": [0.1, 123.00000000000001] },
    { "@id": "pairs", "@type": "FeaturePattern", "template": "acme:Pair", "features": ["other:c", "k"], "subpatterns": ["pair"] } ] })json";

Geometry random_geometry(std::mt19937& random, double side_m) {
  std::uniform_real_distribution<double> place(0, side_m), length(0.2, 12), angle(-3.1, 3.1);
  const Point p{place(random), place(random)};
  switch (random() % 8) {
    case 0: return Circle{p, 0.05 + 0.1 * length(random)};
    case 1: return OrientedPoint{p, angle(random), 1.5};
    case 2: return p;
    case 3: return Segment{p, p + length(random) * Point(1, 0)};
    case 4: return Segment{p, p + length(random) * Point(0, -1)};
    default: break;
  }
  const double length_m = length(random);
  return Segment{p, p + length_m * unit_vector(angle(random))};
}

}  // namespace

std::shared_ptr<const MapStore> store() { return shipped_plugins().make<MapStore>("opal:PostgisStore"); }

Map rich_map() { return SemanticMap::parse(kRichDocument, "rich"); }

Map large_map(int features, unsigned seed) {
  std::mt19937 random(seed);
  const double side_m = 3 * std::sqrt(features);
  std::vector<MapObject> objects;
  std::vector<MapFeature> made;
  for (int k = 0; k < features; ++k) {
    if (k % 3 == 0) objects.push_back({"object-" + std::to_string(k / 3), k % 2 == 0 ? "opal:Wall" : "acme:Thing"});
    MapFeature feature;
    feature.id = "f" + std::to_string(k);
    feature.object = MapObjectNumber(objects.size() - 1);
    feature.sensor = k % 10 == 0 ? "Camera" : k % 17 == 0 ? "" : "PlanarLidar2D";
    feature.geometry = random_geometry(random, side_m);
    made.push_back(feature);
  }
  return SemanticMap::make("large", std::move(objects), std::move(made));
}

Map malaga() {
  static const Map map = shipped_plugins()
                             .make<MapImporter>("opal:GridImporter")
                             ->import(OPAL_SOURCE_DIR "/maps/malaga/malaga.map.yaml")
                             .map;
  return map;
}

}  // namespace opal::store_tests
