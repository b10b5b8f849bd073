#pragma once

#include "map/view/surface_tiles.hpp"

#include <filesystem>
#include <string>

namespace opal {

/// Keeps the tiles of large maps in files, one for each map. They are looked up by content: another map has another
/// file, and so has a program that paints in another way. Two programs may make the same file at once.
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
  void forget_old() const;
  /// @return why nothing is kept, if nothing is: another program may have kept the same meanwhile.
  std::string keep(const std::filesystem::path& file, const std::string& digest, const TileLayout& layout,
                   const SurfaceTiles& tiles) const;

  std::filesystem::path folder_;
  std::size_t from_;
};

}  // namespace opal
