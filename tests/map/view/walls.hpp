#pragma once

#include <opal/map/semantic_map.hpp>

#include <random>

namespace opal {

/// A map of these faces and columns, each an object of its own, perceivable by "PlanarLidar2D".
inline std::shared_ptr<const SemanticMap> map_of(const std::vector<Geometry>& geometries) {
  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  for (const Geometry& geometry : geometries) {
    const int number = static_cast<int>(features.size());
    const bool column = kind_of(geometry) == GeometryKind::circle;
    objects.push_back(
        {"object-" + std::to_string(number), column ? "opal:Column" : "opal:Wall", {MapFeatureNumber(number)}});
    MapFeature feature;
    feature.id = "feature-" + std::to_string(number);
    feature.object = MapObjectNumber(number);
    feature.type = column ? "opal:Column" : "opal:Wall";
    feature.sensor = "PlanarLidar2D";
    feature.geometry = geometry;
    features.push_back(feature);
  }
  return SemanticMap::make("test", objects, features);
}

/// Faces of 0.2 to 9 m anywhere in 60 m x 60 m, with any heading.
inline std::vector<Geometry> random_walls(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 60), size(0.2, 9), heading(-3.14, 3.14);
  std::vector<Geometry> walls;
  for (int k = 0; k < count; ++k) {
    const Point begin{place(random), place(random)};
    const double length_m = size(random);
    walls.push_back(Segment{begin, begin + length_m * unit_vector(heading(random))});
  }
  return walls;
}

}  // namespace opal
