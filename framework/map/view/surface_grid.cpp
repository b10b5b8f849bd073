#include "map/view/surface_grid.hpp"

#include <algorithm>

namespace opal {
namespace {

/// What is painted on a tile.
struct Touch {
  std::uint32_t tile;
  std::uint32_t shape;
};

/// @param touches  in order of tile.
std::size_t count_tiles(const std::vector<Touch>& touches) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < touches.size(); ++k)
    if (k == 0 || touches[k].tile != touches[k - 1].tile) ++count;
  return count;
}

}  // namespace

SurfaceGrid::SurfaceGrid(const Point& low, const Point& high, const std::vector<NumberedShape>& shapes)
    : low_(low - Point::Constant(SurfaceTile::kCap_m + kCell_m)) {
  const Point size = high - low_ + Point::Constant(SurfaceTile::kCap_m + kCell_m);
  columns_ = static_cast<int>(size.x() / (kCell_m * kSide)) + 1;
  rows_ = static_cast<int>(size.y() / (kCell_m * kSide)) + 1;
  cells_ = Point(columns_ * kSide, rows_ * kSide);
  tile_of_.assign(static_cast<std::size_t>(columns_) * rows_, 0);
  names_.emplace_back();   // of none
  blocks_.emplace_back();  // where no surface is in reach
  SurfaceTile tile;
  tile.clear(low_, 0, 0);
  add(tile);
  paint(shapes, tile);
  blocks_.shrink_to_fit();
  names_.shrink_to_fit();
}

void SurfaceGrid::reserve(std::size_t tiles) {
  distances_cm_.reserve(tiles);
  coarse_cm_.reserve(tiles);
  block_of_.reserve(tiles);
}

/// Tile by tile, so that little is in memory that is not kept.
void SurfaceGrid::paint(const std::vector<NumberedShape>& shapes, SurfaceTile& tile) {
  std::vector<Touch> touches;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const TileSpan rows = tile_rows_near(shapes[k].second, low_);
    for (int row = std::max(0, rows.first); row <= std::min(rows_ - 1, rows.last); ++row) {
      const TileSpan columns = tile_columns_near(shapes[k].second, low_, row);
      for (int column = std::max(0, columns.first); column <= std::min(columns_ - 1, columns.last); ++column)
        touches.push_back({static_cast<std::uint32_t>(row * columns_ + column), static_cast<std::uint32_t>(k)});
    }
  }
  std::stable_sort(touches.begin(), touches.end(), [](const Touch& a, const Touch& b) { return a.tile < b.tile; });
  reserve(1 + count_tiles(touches));
  for (auto touch = touches.begin(); touch != touches.end();) {
    const std::uint32_t at = touch->tile;
    tile.clear(low_, static_cast<int>(at) % columns_, static_cast<int>(at) / columns_);
    for (; touch != touches.end() && touch->tile == at; ++touch)
      tile.paint(shapes[touch->shape].first, shapes[touch->shape].second);
    if (!tile.is_empty()) tile_of_[at] = add(tile);
  }
}

std::uint32_t SurfaceGrid::add(const SurfaceTile& tile) {
  distances_cm_.push_back(tile.distances_cm());
  CoarseDistances& coarse = coarse_cm_.emplace_back();
  coarse.fill(SurfaceTile::kFar_cm);
  for (unsigned j = 0; j < kSide; ++j)
    for (unsigned i = 0; i < kSide; ++i) {
      std::uint8_t& least = coarse[coarse_offset_of(i, j)];
      least = std::min(least, tile.distances_cm()[SurfaceTile::offset_of(i, j)]);
    }
  BlockNumbers& numbers = block_of_.emplace_back();
  for (unsigned k = 0; k < SurfaceTile::kBlocks; ++k) {
    numbers[k] = 0;
    if (!tile.names_any(k)) continue;
    numbers[k] = static_cast<std::uint32_t>(blocks_.size());
    blocks_.push_back(tile.block(k, names_));
  }
  return static_cast<std::uint32_t>(distances_cm_.size() - 1);
}

}  // namespace opal
