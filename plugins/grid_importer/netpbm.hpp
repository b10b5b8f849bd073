#pragma once

#include "grey_image.hpp"

#include <string>

namespace opal::grid_importer {

/// Reads PBM, PGM and PPM, as text (P1 to P3) and as bytes (P4 to P6). @pre It begins with one of these.
/// @throws MapError naming the file and the byte.
GreyImage read_netpbm(const std::string& bytes, const std::string& name);

}  // namespace opal::grid_importer
