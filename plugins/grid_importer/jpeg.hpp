#pragma once

#include "grey_image.hpp"

#include <string>

namespace opal::grid_importer {

/// Reads JPEG, grey or colour. Where the picture is one of map_saver, with the shades of occupied, unknown and free
/// cells, these become whole again: compression leaves a few shades around each.
/// @throws MapError naming the file, for a damaged, truncated or oversized image.
GreyImage read_jpeg(const std::string& bytes, const std::string& name);

}  // namespace opal::grid_importer
