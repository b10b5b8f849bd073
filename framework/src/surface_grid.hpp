#pragma once

#include <opal/geometry.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace opal {

/// Distance to, and identity of, the nearest surface for every cell near one: tiles of 64 x 64 cells of 0.1 m, held
/// only where some surface is within the cap. Surfaces of opposite orientation are kept in two layers, so that both
/// faces of a thin wall can be found. Frame: `map`.
class SurfaceGrid {
 public:
  static constexpr double kCell_m = 0.1;
  static constexpr double kReach_m = 0.8;
  static constexpr int kLayers = 2;

  SurfaceGrid(const Point& low, const Point& high);

  /// @param number  what `nearest` answers; heading decides the layer. A circle goes into both.
  void add(int number, const Segment& segment);
  void add(int number, const Circle& circle);

  /// Distance to the nearest surface [cm], 255 if farther.
  std::uint8_t distance_cm(const Point& p) const {
    const Cell at = locate(p);
    return at.tile ? at.tile->distance_cm[at.offset] : 255;
  }
  /// The same for a point in cells from the grid's corner, for those who walk along a line.
  Point in_cells(const Point& p) const { return (p - low_) * (1 / kCell_m); }
  std::uint8_t distance_cm_in_cells(const Point& cells) const {
    const Cell at = locate_in_cells(cells);
    return at.tile ? at.tile->distance_cm[at.offset] : 255;
  }
  /// Nearest surface within kReach_m of the cell in a layer, or -1.
  int nearest(const Point& p, int layer) const {
    const Cell at = locate(p);
    return at.tile ? at.tile->nearest[layer][at.offset] : -1;
  }
  std::array<int, kLayers> nearest(const Point& p) const {
    const Cell at = locate(p);
    if (!at.tile) return {-1, -1};
    return {at.tile->nearest[0][at.offset], at.tile->nearest[1][at.offset]};
  }

 private:
  static constexpr int kSide = 64;
  struct Tile {
    Tile();
    std::array<std::uint8_t, kSide * kSide> distance_cm;
    std::array<std::array<std::int32_t, kSide * kSide>, kLayers> nearest;
    std::array<std::array<std::uint8_t, kSide * kSide>, kLayers> layer_distance_cm;
  };
  struct Cell {
    const Tile* tile = nullptr;
    int offset = 0;
  };

  Cell locate(const Point& p) const { return locate_in_cells(in_cells(p)); }
  Cell locate_in_cells(const Point& cells) const {
    const double u = cells.x(), v = cells.y();
    if (!(u >= 0 && v >= 0 && u < columns_ * kSide && v < rows_ * kSide)) return {};
    const int i = static_cast<int>(u), j = static_cast<int>(v);
    const Tile* tile = tiles_[static_cast<std::size_t>(j / kSide) * columns_ + i / kSide].get();
    return {tile, (j % kSide) * kSide + i % kSide};
  }

  void paint_cell(int i, int j, double distance_m, int number, int first_layer, int last_layer);

  Point low_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::unique_ptr<Tile>> tiles_;
};

}  // namespace opal
