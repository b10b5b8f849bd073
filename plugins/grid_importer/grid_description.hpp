#pragma once

#include <opal/common/geometry.hpp>

#include <string>
#include <vector>

namespace opal::grid_importer {

/// How pixel values become occupancy (ROS map_server, parameter `mode`).
enum class GridMode { trinary, scale, raw };

/// The yaml file of a map_server grid.
struct GridDescription {
  std::string image;  ///< as written: relative to the yaml file, or absolute
  double resolution_m = 0;
  Pose2 T_map_grid;  ///< `origin`: the lower left corner of the image, turned by its yaw
  GridMode mode = GridMode::trinary;
  bool negate = false;
  double occupied_threshold = 0.65;
  double free_threshold = 0.196;  ///< above the other one: what is not occupied is free, and nothing is unknown between
  bool keeps_grey_unknown = false;  ///< the grey of unknown cells stays so, although free_threshold makes it free
  bool lacks_yaw = false;           ///< the origin's yaw is NaN, as where a quaternion was none; 0 is taken
  /// The image that is there, called as the yaml file is; empty: the named one is there.
  std::string image_in_place_of_named = {};
  std::vector<std::string> ignored_keys;
};

/// @param name  what the text is called in messages: the file's path.
/// @throws MapError naming the line, the key, what was found and what was expected.
GridDescription parse_description(const std::string& text, const std::string& name);

}  // namespace opal::grid_importer
