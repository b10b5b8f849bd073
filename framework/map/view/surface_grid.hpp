#pragma once

#include <opal/common/geometry.hpp>
#include <opal/map/map_numbers.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace opal {

/// Distance to, and identity of, the nearest surface for every cell near one: tiles of 64 x 64 cells of 0.1 m, held
/// only where some surface is within the cap. Surfaces of opposite orientation are kept in two layers, so that both
/// faces of a thin wall can be found. Frame: `map`.
///
/// Distances lie apart from identities, and once more in cells of 0.4 m: a search looks at far more places than it
/// looks at closely, and in a large map what it waits for is memory.
class SurfaceGrid {
 public:
  static constexpr double kCell_m = 0.1;
  static constexpr double kReach_m = 0.8;
  static constexpr int kLayers = 2;

  /// A segment or a circle, and what `nearest` answers. A segment's heading decides its layer, a circle goes into both;
  /// other shapes have no surface.
  using NumberedShape = std::pair<MapFeatureNumber, Geometry>;
  SurfaceGrid(const Point& low, const Point& high, const std::vector<NumberedShape>& shapes);

  /// Distance to the nearest surface [cm], 255 if farther.
  std::uint8_t distance_cm(const Point& p) const {
    const Cell at = locate(p);
    return distances_cm_[at.tile][offset_of(at.i, at.j)];
  }
  /// The same for a point in cells from the grid's corner, for those who walk along a line.
  Point in_cells(const Point& p) const { return (p - low_) * (1 / kCell_m); }
  std::uint8_t distance_cm_in_cells(const Point& cells) const {
    const Cell at = locate_in_cells(cells);
    return distances_cm_[at.tile][offset_of(at.i, at.j)];
  }
  /// The least of it in the cell of 0.4 m around p.
  std::uint8_t coarse_distance_cm(const Point& p) const {
    const Cell at = locate(p);
    return coarse_cm_[at.tile][coarse_offset_of(at.i, at.j)];
  }
  /// Nearest surface within kReach_m of the cell in each layer, or none.
  std::array<MapFeatureNumber, kLayers> nearest(const Point& p) const {
    const Cell at = locate(p);
    return (*nearest_[at.tile])[offset_of(at.i, at.j)];
  }

 private:
  static constexpr int kSide = 64;
  static constexpr int kCells = kSide * kSide;
  static constexpr int kCoarse = 4;  ///< cells to a side of a coarse one
  using Distances = std::array<std::uint8_t, kCells>;
  using CoarseDistances = std::array<std::uint8_t, kCells / (kCoarse * kCoarse)>;
  using Nearest = std::array<std::array<MapFeatureNumber, kLayers>, kCells>;
  struct Painting;

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
  /// Blocks of 8 x 8 cells lie together, a cache line of distances each: whoever goes on by a cell or two, in whatever
  /// direction, mostly stays there.
  static unsigned offset_of(unsigned i, unsigned j) { return (j / 8 * (kSide / 8) + i / 8) * 64 + j % 8 * 8 + i % 8; }
  static unsigned coarse_offset_of(unsigned i, unsigned j) { return j / kCoarse * (kSide / kCoarse) + i / kCoarse; }

  std::uint32_t add_tile(Painting& painting);
  void paint(Painting& painting, MapFeatureNumber number, const Segment& segment);
  void paint(Painting& painting, MapFeatureNumber number, const Circle& circle);
  void paint_cell(Painting& painting, int i, int j, double distance_m, MapFeatureNumber number, int first_layer,
                  int last_layer);
  void make_coarse();

  Point low_;
  Point cells_;      ///< in x and y
  int columns_ = 0;  ///< of tiles
  int rows_ = 0;
  std::vector<std::uint32_t> tile_of_;
  std::vector<Distances> distances_cm_;
  std::vector<CoarseDistances> coarse_cm_;
  std::vector<std::unique_ptr<Nearest>> nearest_;
};

}  // namespace opal
