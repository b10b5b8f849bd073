#pragma once

#include "map/view/surface_tile.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

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

  /// A segment or a circle, and what `nearest` answers. A segment's heading decides its layer, a circle goes into both;
  /// other shapes have no surface.
  using NumberedShape = std::pair<MapFeatureNumber, Geometry>;
  SurfaceGrid(const Point& low, const Point& high, const std::vector<NumberedShape>& shapes);

  /// Distance to the nearest surface [cm], 255 if farther.
  std::uint8_t distance_cm(const Point& p) const {
    const Cell at = locate(p);
    return distances_cm_[at.tile][SurfaceTile::offset_of(at.i, at.j)];
  }
  /// The same for a point in cells from the grid's corner, for those who walk along a line.
  Point in_cells(const Point& p) const { return (p - low_) * (1 / kCell_m); }
  std::uint8_t distance_cm_in_cells(const Point& cells) const {
    const Cell at = locate_in_cells(cells);
    return distances_cm_[at.tile][SurfaceTile::offset_of(at.i, at.j)];
  }
  /// The least of it in the cell of 0.4 m around p.
  std::uint8_t coarse_distance_cm(const Point& p) const {
    const Cell at = locate(p);
    return coarse_cm_[at.tile][coarse_offset_of(at.i, at.j)];
  }
  /// Nearest surface within SurfaceTile::kReach_m of the cell in each layer, or none.
  std::array<MapFeatureNumber, NearestBlock::kLayers> nearest(const Point& p) const {
    const Cell at = locate(p);
    const unsigned offset = SurfaceTile::offset_of(at.i, at.j);
    const NearestBlock& block = blocks_[block_of_[at.tile][offset / NearestBlock::kCells]];
    const auto& [first, second] = block.position[offset % NearestBlock::kCells];
    return {names_[block.list_begin + first], names_[block.list_begin + second]};
  }

 private:
  static constexpr int kSide = SurfaceTile::kSide;
  static constexpr int kCoarse = 4;  ///< cells to a side of a coarse one
  using CoarseDistances = std::array<std::uint8_t, SurfaceTile::kCells / (kCoarse * kCoarse)>;
  using BlockNumbers = std::array<std::uint32_t, SurfaceTile::kBlocks>;

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
    return {tile_of_[static_cast<std::size_t>(j / kSide) * columns_ + i / kSide], i % kSide, j % kSide};
  }
  static unsigned coarse_offset_of(unsigned i, unsigned j) { return j / kCoarse * (kSide / kCoarse) + i / kCoarse; }

  void reserve(std::size_t tiles);
  void paint(const std::vector<NumberedShape>& shapes, SurfaceTile& tile);
  std::uint32_t add(const SurfaceTile& tile);

  Point low_;
  Point cells_;      ///< in x and y
  int columns_ = 0;  ///< of tiles
  int rows_ = 0;
  std::vector<std::uint32_t> tile_of_;
  std::vector<SurfaceTile::Distances> distances_cm_;  ///< by tile
  std::vector<CoarseDistances> coarse_cm_;            ///< by tile
  std::vector<BlockNumbers> block_of_;                ///< by tile; 0: no surface is in reach
  std::vector<NearestBlock> blocks_;
  std::vector<MapFeatureNumber> names_;  ///< of the blocks' lists, each of which begins with none
};

}  // namespace opal
