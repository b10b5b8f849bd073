#pragma once

#include "common/prepared/read_only_array.hpp"
#include "map/view/surface_tile.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace opal {

/// How a map is covered with tiles. Frame: `map`.
struct OPAL_EXPORT TileLayout {
  Point low = Point::Zero();  ///< corner of the first tile [m]
  int columns = 0, rows = 0;  ///< of tiles

  /// For surfaces between two corners of the map [m].
  static TileLayout around(const Point& low, const Point& high);
  std::size_t tiles() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

/// A segment or a circle, and what names it; other shapes have no surface.
using NumberedShape = std::pair<MapFeatureNumber, Geometry>;

/// What is kept of the tiles of a map: those that some surface is near.
struct SurfaceTiles {
  static constexpr int kCoarse = 4;  ///< cells to a side of a coarse one
  using CoarseDistances = std::array<std::uint8_t, SurfaceTile::kCells / (kCoarse * kCoarse)>;
  using BlockNumbers = std::array<std::uint32_t, SurfaceTile::kBlocks>;

  static unsigned coarse_offset_of(unsigned i, unsigned j) {
    return j / kCoarse * (SurfaceTile::kSide / kCoarse) + i / kCoarse;
  }

  ReadOnlyArray<std::uint32_t> tile_of;  ///< by place, row after row. 0: no surface is near; that tile holds none
  ReadOnlyArray<SurfaceTile::Distances> distances_cm;  ///< by tile
  ReadOnlyArray<CoarseDistances> coarse_cm;            ///< by tile
  ReadOnlyArray<BlockNumbers> block_of;                ///< by tile; 0: no surface is in reach
  ReadOnlyArray<NearestBlock> blocks;
  ReadOnlyArray<MapFeatureNumber> names;  ///< of the blocks' lists, each of which begins with none
};

/// Paints all shapes, tile by tile, so that little is in memory that is not kept.
OPAL_EXPORT SurfaceTiles painted(const TileLayout& layout, const std::vector<NumberedShape>& shapes);

}  // namespace opal
