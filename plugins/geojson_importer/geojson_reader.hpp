#pragma once

#include <opal/common/geometry.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace opal::geojson_importer {

/// A ring without its last position, which repeats the first.
using Ring = std::vector<Point>;

/// Everything that a geometry of GeoJSON is made of; in the coordinates of the file (x or longitude first).
struct Shapes {
  std::vector<Point> points;
  std::vector<std::vector<Point>> lines;
  std::vector<std::vector<Ring>> polygons;  ///< outer ring, holes
};

struct Feature {
  std::string id;        ///< "feature-3" if it has none
  std::string geometry;  ///< "Polygon"; "" if it has none
  nlohmann::json properties = nlohmann::json::object();
  Shapes shapes;
};

struct FeatureCollection {
  std::string name;  ///< empty: the file does not say
  std::vector<Feature> features;
  bool has_crs = false;  ///< the member `crs` of 2008, which RFC 7946 took away
};

/// Reads GeoJSON (RFC 7946): a FeatureCollection, or one Feature.
/// @throws MapError "PATH: POINTER: what was found, what was expected".
FeatureCollection read_geojson(const std::string& path);

}  // namespace opal::geojson_importer
