#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace opal::grid_importer {

/// A picture as map_server sees it: how bright and how opaque each pixel is, 0 to 1. Rows from top to bottom.
struct GreyImage {
  int width = 0;
  int height = 0;
  std::vector<float> brightness;  ///< mean of the colour channels
  std::vector<float> opacity;     ///< empty: the file has no alpha channel
};

/// @throws MapError for an image without pixels, or one larger than any building.
void check_size(std::uint64_t width, std::uint64_t height, const std::string& name);

/// Reads Netpbm (P1 to P6, 8 and 16 bit), PNG (grey, colour, palette, alpha, 1 to 16 bit), BMP without compression and
/// JPEG, told apart by their first bytes.
/// @param bytes  the whole file. @param name  what it is called in messages.
/// @throws MapError naming the file and the place, for a damaged, truncated, foreign or oversized file.
GreyImage decode_image(const std::string& bytes, const std::string& name);

}  // namespace opal::grid_importer
