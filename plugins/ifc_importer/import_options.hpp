#pragma once

#include <opal/common/geometry.hpp>

#include <map>
#include <optional>
#include <string>

namespace opal::ifc_importer {

/// As plugin.jsonld describes them.
struct ImportOptions {
  std::string storey;
  std::optional<double> z_m;
  double sensor_height_m = 0.3;
  std::string sensor = "PlanarLidar2D";
  Point origin_m = Point::Zero();  ///< what lies here in the model is the map's origin
  std::map<std::string, std::string> classes;
};

}  // namespace opal::ifc_importer
