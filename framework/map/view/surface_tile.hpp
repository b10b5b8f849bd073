#pragma once

#include <opal/common/geometry.hpp>
#include <opal/map/map_numbers.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace opal {

/// Names of the nearest surfaces in 8 x 8 cells, as positions in a short list of those that occur there.
struct NearestBlock {
  static constexpr unsigned kSide = 8, kCells = kSide * kSide;
  static constexpr int kLayers = 2;
  /// In each layer; 0: none.
  std::array<std::array<std::uint8_t, kLayers>, kCells> position{};
  std::uint32_t list_begin = 0;  ///< where the list begins that the positions are in
};

/// A square of 64 x 64 cells of a map while surfaces are painted on it: all that is known of each cell. Frame: `map`.
class SurfaceTile {
 public:
  static constexpr double kCell_m = 0.1;
  static constexpr double kReach_m = 0.8;  ///< farther surfaces have no name
  static constexpr double kCap_m = 2.5;    ///< farther surfaces are not seen at all
  static constexpr std::uint8_t kFar_cm = 255;
  static constexpr int kLayers = NearestBlock::kLayers;
  static constexpr int kSide = 64, kCells = kSide * kSide;
  static constexpr double kTile_m = kCell_m * kSide;
  static constexpr unsigned kBlocks = kCells / NearestBlock::kCells;
  using Distances = std::array<std::uint8_t, kCells>;

  /// Blocks of 8 x 8 cells lie together, a cache line of distances each: whoever goes on by a cell or two, in whatever
  /// direction, mostly stays there.
  static constexpr unsigned offset_of(unsigned i, unsigned j) {
    constexpr unsigned kBlock = NearestBlock::kSide;
    return (j / kBlock * (kSide / kBlock) + i / kBlock) * NearestBlock::kCells + j % kBlock * kBlock + i % kBlock;
  }

  /// Begins a tile with nothing on it.
  /// @param grid_corner  low corner of the whole grid [m].
  /// @param column, row  of the tile in the grid.
  void clear(const Point& grid_corner, int column, int row);
  /// Surfaces come in a fixed order: of two that are as near, the first is named. Other shapes leave nothing.
  void paint(MapFeatureNumber number, const Geometry& shape);

  bool is_empty() const { return is_empty_; }
  /// To the nearest surface [cm], by offset.
  const Distances& distances_cm() const { return distances_cm_; }
  /// The nearest surfaces in a block. @param names  what it names is appended.
  NearestBlock block(unsigned number, std::vector<MapFeatureNumber>& names) const;
  /// True if a block names a surface.
  bool names_any(unsigned block) const;

 private:
  using PerLayer = std::array<MapFeatureNumber, kLayers>;
  void paint(MapFeatureNumber number, const Segment& segment);
  void paint(MapFeatureNumber number, const Circle& circle);
  void paint_cell(int i, int j, double distance_m, MapFeatureNumber number, int first_layer, int last_layer);
  Point center_of(int i, int j) const { return grid_corner_ + kCell_m * Point(i + 0.5, j + 0.5); }

  Point grid_corner_ = Point::Zero();
  int i_low_ = 0, j_low_ = 0;  ///< first cell of the tile, in the grid
  bool is_empty_ = true;
  Distances distances_cm_;
  std::array<std::array<std::uint8_t, kCells>, kLayers> layer_distances_cm_;
  std::array<PerLayer, kCells> nearest_;
};

/// Tiles of a grid along one axis, first and last; they may lie beyond the grid.
struct TileSpan {
  int first = 0, last = -1;
};
/// The rows of tiles on which a shape may leave something; none for shapes that are no surface.
/// @param grid_corner  low corner of the grid [m].
TileSpan tile_rows_near(const Geometry& shape, const Point& grid_corner);
/// The same for the tiles of one of these rows.
TileSpan tile_columns_near(const Geometry& shape, const Point& grid_corner, int row);

}  // namespace opal
