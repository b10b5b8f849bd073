#pragma once

#include "geojson_reader.hpp"

#include <optional>
#include <string>
#include <vector>

namespace opal::geojson_importer {

/// How coordinates of a file become metres in the `map` frame.
struct PlacementOptions {
  std::optional<bool> is_geographic;  ///< none: as the coordinates look, and as the file's crs says
  std::optional<Point> origin_deg;    ///< none: the middle of everything
  std::string origin_file = {};       ///< from which `origin_deg` came; empty: from none
  Point origin_m = Point::Zero();     ///< of a plan that is not in degrees
  std::string unit = {};              ///< of such a plan: one that length_unit_called() knows; empty: metres
  bool y_down = false;                ///< of such a plan: y runs downwards, as in an image
};

/// The middle of a plan; none: it is in metres. Coordinates of web maps become degrees.
std::optional<Point> middle_deg(const PlacementOptions& options, FeatureCollection& collection);

/// All coordinates to metres in the `map` frame. Coordinates that look like degrees are degrees, whatever the file's
/// crs says, unless the options say otherwise.
/// @param path  stands for the file in messages.
/// @return sentences about it.
/// @throws MapError for degrees that no building reaches over, and for what is no longitude and latitude if that is
/// asked for.
std::vector<std::string> place(const std::string& path, const PlacementOptions& options, FeatureCollection& collection);

}  // namespace opal::geojson_importer
