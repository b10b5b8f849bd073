#pragma once

#include "common/prepared/prepared_folder.hpp"
#include "map/view/surface_tiles.hpp"

#include <filesystem>

namespace opal {

/// Keeps the tiles of large maps in files, one for each map.
class OPAL_EXPORT TileCache {
 public:
  /// The tiles of smaller maps are painted sooner than a file is opened and checked.
  static constexpr std::size_t kLargeMap = 10000;

  /// @param folder  made when needed; empty: nothing is kept.
  /// @param from  so many shapes on, tiles are kept.
  explicit TileCache(std::filesystem::path folder, std::size_t from = kLargeMap)
      : folder_(std::move(folder)), from_(from) {}

  /// Painted, or as a file has them. What cannot be kept is painted, and a warning says so.
  /// @param features  every number of a shape is less.
  SurfaceTiles tiles_of(const TileLayout& layout, const std::vector<NumberedShape>& shapes, int features) const;

 private:
  PreparedFolder folder_;
  std::size_t from_;
};

}  // namespace opal
