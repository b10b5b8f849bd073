#pragma once

#include "map/view/surface_tiles.hpp"

#include <array>
#include <cstdint>
#include <utility>

namespace opal {

/// Distance to, and identity of, the nearest surface for every cell near one: tiles of 64 x 64 cells of 0.1 m, held
/// only where some surface is within the cap. Few surfaces are in reach of a block of cells, so cells hold positions in
/// a list of these. Surfaces of opposite orientation are kept in two layers, so that both
/// faces of a thin wall can be found. Frame: `map`.
///
/// Distances lie apart from identities, and once more in cells of 0.4 m: a search looks at far more places than it
/// looks at closely, and in a large map what it waits for is memory.
class SurfaceGrid {
 public:
  static constexpr double kCell_m = SurfaceTile::kCell_m;

  SurfaceGrid(const TileLayout& layout, SurfaceTiles tiles)
      : low_(layout.low),
        cells_(layout.columns * kSide, layout.rows * kSide),
        columns_(layout.columns),
        tiles_(std::move(tiles)) {}

  /// Distance to the nearest surface [cm], 255 if farther.
  std::uint8_t distance_cm(const Point& p) const {
    const Cell at = locate(p);
    return tiles_.distances_cm[at.tile][SurfaceTile::offset_of(at.i, at.j)];
  }
  /// The same for a point in cells from the grid's corner, for those who walk along a line.
  Point in_cells(const Point& p) const { return (p - low_) * (1 / kCell_m); }
  std::uint8_t distance_cm_in_cells(const Point& cells) const {
    const Cell at = locate_in_cells(cells);
    return tiles_.distances_cm[at.tile][SurfaceTile::offset_of(at.i, at.j)];
  }
  /// The least of it in the cell of 0.4 m around p.
  std::uint8_t coarse_distance_cm(const Point& p) const {
    const Cell at = locate(p);
    return tiles_.coarse_cm[at.tile][SurfaceTiles::coarse_offset_of(at.i, at.j)];
  }
  /// Nearest surface within SurfaceTile::kReach_m of the cell in each layer, or none.
  std::array<MapFeatureNumber, NearestBlock::kLayers> nearest(const Point& p) const {
    const Cell at = locate(p);
    const unsigned offset = SurfaceTile::offset_of(at.i, at.j);
    const NearestBlock& block = tiles_.blocks[tiles_.block_of[at.tile][offset / NearestBlock::kCells]];
    const auto& [first, second] = block.position[offset % NearestBlock::kCells];
    return {tiles_.names[block.list_begin + first], tiles_.names[block.list_begin + second]};
  }

 private:
  static constexpr int kSide = SurfaceTile::kSide;

  /// Tile 0 is that of all places with no surface near, so that looking one up takes no decision.
  struct Cell {
    std::uint32_t tile = 0;
    unsigned i = 0, j = 0;  ///< in the tile
  };
  Cell locate(const Point& p) const { return locate_in_cells(in_cells(p)); }
  Cell locate_in_cells(const Point& cells) const {
    const double u = cells.x(), v = cells.y();
    if (!(u >= 0 && v >= 0 && u < cells_.x() && v < cells_.y())) return {};
    const auto i = static_cast<unsigned>(static_cast<int>(u)), j = static_cast<unsigned>(static_cast<int>(v));
    return {tiles_.tile_of[static_cast<std::size_t>(j / kSide) * columns_ + i / kSide], i % kSide, j % kSide};
  }

  Point low_;
  Point cells_;      ///< in x and y
  int columns_ = 0;  ///< of tiles
  SurfaceTiles tiles_;
};

}  // namespace opal
