#pragma once

#include "grey_image.hpp"

#include <string>

namespace opal::grid_importer {

/// Reads a BMP image without compression, with a palette (1, 4 or 8 bit) or colours (24 or 32 bit; opaque), as
/// map_saver writes it. @throws MapError naming the file and what is wrong in it.
GreyImage read_bmp(const std::string& bytes, const std::string& name);

}  // namespace opal::grid_importer
