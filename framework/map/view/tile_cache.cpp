#include "map/view/tile_cache.hpp"

#include "common/whole_file.hpp"
#include "common/write_error.hpp"
#include "map/view/tile_file.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <optional>
#include <string>

namespace opal {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".tiles";

void touch(const fs::path& file) {
  std::error_code ignored;
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
}

}  // namespace

/// Maps change, and nobody asks for the old ones again.
void TileCache::forget_old() const {
  constexpr std::chrono::hours kUnused(24 * 30);
  std::error_code ignored;
  const auto now = fs::file_time_type::clock::now();
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, ignored))
    if (entry.path().extension() == kEnding && now - entry.last_write_time(ignored) > kUnused)
      fs::remove(entry.path(), ignored);
}

SurfaceTiles TileCache::tiles_of(const TileLayout& layout, const std::vector<NumberedShape>& shapes,
                                 int features) const {
  if (folder_.empty() || shapes.size() < from_) return painted(layout, shapes);
  const std::string digest = digest_of(layout, shapes);
  const fs::path file = folder_ / (digest + kEnding);
  if (std::optional<SurfaceTiles> kept = read_tiles(file, digest, layout, features)) {
    touch(file);
    return std::move(*kept);
  }
  SurfaceTiles made = painted(layout, shapes);
  const std::string complaint = keep(file, digest, layout, made);
  if (std::optional<SurfaceTiles> kept = read_tiles(file, digest, layout, features)) return std::move(*kept);
  spdlog::warn("the prepared map is not kept: {}", complaint);
  return made;
}

std::string TileCache::keep(const fs::path& file, const std::string& digest, const TileLayout& layout,
                            const SurfaceTiles& tiles) const try {
  make_folder(folder_.string());
  forget_old();
  write_tiles(file, digest, layout, tiles);
  return "it cannot be read back";
} catch (const WriteError& error) {
  return error.what();
}

}  // namespace opal
