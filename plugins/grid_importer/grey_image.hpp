#pragma once

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

/// Reads PGM (P2, P5, 8 and 16 bit) and PNG, told apart by their first bytes.
/// @param bytes  the whole file. @param name  what it is called in messages.
/// @throws MapError naming the file and the place, for a damaged, truncated, foreign or oversized file.
GreyImage decode_image(const std::string& bytes, const std::string& name);

}  // namespace opal::grid_importer
