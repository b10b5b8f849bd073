#include "map/view/tile_cache.hpp"

#include "map/view/tile_file.hpp"

namespace opal {

SurfaceTiles TileCache::tiles_of(const TileLayout& layout, const std::vector<NumberedShape>& shapes,
                                 int features) const {
  if (!folder_.keeps() || shapes.size() < from_) return painted(layout, shapes);
  const std::string digest = digest_of(layout, shapes);
  return folder_.kept<SurfaceTiles>(
      digest + ".tiles", [&](const std::filesystem::path& file) { return read_tiles(file, digest, layout, features); },
      [&] { return painted(layout, shapes); },
      [&](const std::filesystem::path& file, const SurfaceTiles& tiles) { write_tiles(file, digest, tiles); });
}

}  // namespace opal
