#include "grid.hpp"

#include <opal/common/error.hpp>
#include <opal/common/letter_case.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace opal::grid_importer {
namespace {

namespace fs = std::filesystem;

// As many bytes as the largest image that decode_image takes has, as plain text.
constexpr std::uint64_t kMaxImageBytes = (std::uint64_t{1} << 28) + 4096;
constexpr std::uint64_t kMaxYamlBytes = std::uint64_t{1} << 20;

// What map_saver writes, whatever its thresholds are: occupied, unknown and free cells; 255 comes from retouching.
constexpr int kOccupiedGrey = 0, kUnknownGrey = 205, kFreeGrey = 254, kWhite = 255;

int grey_of(float brightness) { return static_cast<int>(std::lround(brightness * 255)); }

/// Whether map_saver wrote the picture, and a threshold that makes its grey of unknown cells free, as map_saver of
/// ROS 2 did up to 2025. Whoever wanted those cells free would have painted them so.
bool means_grey_unknown(const GreyImage& image, const GridDescription& description) {
  // Painting programs add an alpha channel, which trinary mode averages in: then this grey is free by usual thresholds.
  const double shade = kUnknownGrey / 255.0, occupancy = 1 - (image.opacity.empty() ? shade : (3 * shade + 1) / 4);
  if (description.mode != GridMode::trinary || description.negate || description.free_threshold <= occupancy ||
      description.free_threshold >= description.occupied_threshold)
    return false;
  bool has_unknown = false, has_free = false;
  for (std::size_t k = 0; k < image.brightness.size(); ++k) {
    const float opacity = image.opacity.empty() ? 1.0F : image.opacity[k];
    if (opacity == 0) continue;
    const int grey = grey_of(image.brightness[k]);
    if (opacity < 1) return false;
    if (grey != kOccupiedGrey && grey != kUnknownGrey && grey != kFreeGrey && grey != kWhite) return false;
    has_unknown |= grey == kUnknownGrey;
    has_free |= grey == kFreeGrey;
  }
  return has_unknown && has_free;
}

/// Pixel values as map_server reads them, one object per grid (map_io of nav2_map_server documents the rules).
class PixelRules {
 public:
  PixelRules(const GreyImage& image, const GridDescription& description) : image_(image), description_(description) {}

  Occupancy operator()(std::size_t pixel) const {
    const double opacity = image_.opacity.empty() ? 1.0 : image_.opacity[pixel];
    if (opacity == 0) return Occupancy::unknown;  // whatever colour nobody sees
    const double brightness = image_.brightness[pixel];
    if (description_.keeps_grey_unknown && grey_of(image_.brightness[pixel]) == kUnknownGrey) return Occupancy::unknown;
    switch (description_.mode) {
      case GridMode::raw: return raw(brightness);
      case GridMode::scale: return opacity < 1 ? Occupancy::unknown : thresholded(brightness);
      case GridMode::trinary: break;
    }
    // Trinary mode averages the alpha channel in with the three colours.
    return thresholded(image_.opacity.empty() ? brightness : (3 * brightness + opacity) / 4);
  }

 private:
  Occupancy thresholded(double shade) const {
    const double occupancy = description_.negate ? shade : 1 - shade;
    if (occupancy > description_.occupied_threshold) return Occupancy::occupied;
    return occupancy < description_.free_threshold ? Occupancy::free : Occupancy::unknown;
  }

  /// In raw mode the byte itself is the occupancy in percent; above 100 is unknown; `negate` is not used.
  Occupancy raw(double brightness) const {
    const double percent = std::round(brightness * 255);
    if (percent > 100) return Occupancy::unknown;
    if (percent > 100 * description_.occupied_threshold) return Occupancy::occupied;
    return percent < 100 * description_.free_threshold ? Occupancy::free : Occupancy::unknown;
  }

  const GreyImage& image_;
  const GridDescription& description_;
};

/// The file of this name in a folder, in upper or lower case; empty: there is none.
std::string file_called(const fs::path& folder, const std::string& name) {
  std::error_code error;
  const std::string wanted = lower_case_letters(name);
  for (const auto& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, error))
    if (lower_case_letters(entry.path().filename().string()) == wanted && entry.is_regular_file(error))
      return (folder / entry.path().filename()).string();
  return "";
}

/// An absolute image replaces the folder. If it is not there, its name beside the yaml file may be: both were copied,
/// perhaps from Windows. If that is not there, either, an image that is called as the yaml file is may be: both were
/// renamed, which is told.
std::string image_path(const std::string& yaml_path, GridDescription& description) {
  const fs::path folder = fs::path(yaml_path).parent_path(), named = folder / description.image;
  std::error_code error;
  if (fs::exists(named, error)) return named.string();
  const std::string name = description.image.substr(description.image.find_last_of("/\\") + 1);
  if (const std::string beside = file_called(folder, name); !beside.empty()) return beside;
  const std::string ending = fs::path(name).extension().string();
  const std::string renamed = file_called(folder, fs::path(yaml_path).stem().string() + ending);
  if (ending.empty() || renamed.empty()) return named.string();
  description.image_in_place_of_named = fs::path(renamed).filename().string();
  return renamed;
}

}  // namespace

OccupancyGrid::OccupancyGrid(int columns, int rows, double resolution_m, const Pose2& T_map_grid)
    : columns_(columns),
      rows_(rows),
      resolution_m_(resolution_m),
      T_map_grid_(T_map_grid),
      cells_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), Occupancy::unknown) {}

namespace {

/// Of a plan that was drawn on nothing: what is transparent is the paper.
void free_transparent(const GreyImage& image, OccupancyGrid& grid) {
  const auto is_free = [](Occupancy occupancy) { return occupancy == Occupancy::free; };
  if (image.opacity.empty() || std::any_of(grid.cells().begin(), grid.cells().end(), is_free)) return;
  std::size_t pixel = 0;
  for (int row = image.height - 1; row >= 0; --row)
    for (int column = 0; column < image.width; ++column)
      if (image.opacity[pixel++] == 0) grid.set({column, row}, Occupancy::free);
}

}  // namespace

OccupancyGrid classify(const GreyImage& image, const GridDescription& description) {
  OccupancyGrid grid(image.width, image.height, description.resolution_m, description.T_map_grid);
  const PixelRules occupancy_of(image, description);
  std::size_t pixel = 0;
  for (int row = image.height - 1; row >= 0; --row)  // the image begins at the top
    for (int column = 0; column < image.width; ++column) grid.set({column, row}, occupancy_of(pixel++));
  if (description.mode != GridMode::raw) free_transparent(image, grid);
  return grid;
}

std::string read_bytes(const std::string& path, std::uint64_t max_bytes) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw MapError(path + ": cannot read the file: " + error.message());
  if (size > max_bytes) throw MapError(fmt::format("{}: {} bytes, expected at most {}", path, size, max_bytes));
  std::ifstream file(path, std::ios::binary);
  std::string bytes(size, '\0');
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size)) && size > 0)
    throw MapError(fmt::format("{}: cannot read the file: only {} of {} bytes came", path, file.gcount(), size));
  return bytes;
}

OccupancyGrid read_grid(const std::string& yaml_path, GridDescription& description) {
  description = parse_description(read_bytes(yaml_path, kMaxYamlBytes), yaml_path);
  const std::string image = image_path(yaml_path, description);
  const GreyImage pixels = decode_image(read_bytes(image, kMaxImageBytes), image);
  description.keeps_grey_unknown = means_grey_unknown(pixels, description);
  return classify(pixels, description);
}

}  // namespace opal::grid_importer
