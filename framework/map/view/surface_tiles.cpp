#include "map/view/surface_tiles.hpp"

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

/// Tiles while they are painted.
class Painting {
 public:
  Painting(const TileLayout& layout, const std::vector<NumberedShape>& shapes) : layout_(layout), shapes_(shapes) {
    names_.emplace_back();   // of none
    blocks_.emplace_back();  // where no surface is in reach
    tile_.clear(layout_.low, 0, 0);
    keep_tile();
  }

  SurfaceTiles finished() {
    std::vector<std::uint32_t> tile_of(layout_.tiles(), 0);
    const std::vector<Touch> touches = touches_in_order();
    reserve(1 + count_tiles(touches));
    for (auto touch = touches.begin(); touch != touches.end();) {
      const std::uint32_t at = touch->tile;
      tile_.clear(layout_.low, static_cast<int>(at) % layout_.columns, static_cast<int>(at) / layout_.columns);
      for (; touch != touches.end() && touch->tile == at; ++touch)
        tile_.paint(shapes_[touch->shape].first, shapes_[touch->shape].second);
      if (!tile_.is_empty()) tile_of[at] = keep_tile();
    }
    blocks_.shrink_to_fit();
    names_.shrink_to_fit();
    return {ReadOnlyArray(std::move(tile_of)),    ReadOnlyArray(std::move(distances_cm_)),
            ReadOnlyArray(std::move(coarse_cm_)), ReadOnlyArray(std::move(block_of_)),
            ReadOnlyArray(std::move(blocks_)),    ReadOnlyArray(std::move(names_))};
  }

 private:
  void reserve(std::size_t tiles) {
    distances_cm_.reserve(tiles);
    coarse_cm_.reserve(tiles);
    block_of_.reserve(tiles);
  }

  std::vector<Touch> touches_in_order() const {
    std::vector<Touch> touches;
    for (std::size_t k = 0; k < shapes_.size(); ++k) {
      const TileSpan rows = tile_rows_near(shapes_[k].second, layout_.low);
      for (int row = std::max(0, rows.first); row <= std::min(layout_.rows - 1, rows.last); ++row) {
        const TileSpan columns = tile_columns_near(shapes_[k].second, layout_.low, row);
        const int last = std::min(layout_.columns - 1, columns.last);
        for (int column = std::max(0, columns.first); column <= last; ++column)
          touches.push_back(
              {static_cast<std::uint32_t>(row * layout_.columns + column), static_cast<std::uint32_t>(k)});
      }
    }
    std::ranges::stable_sort(touches, {}, &Touch::tile);
    return touches;
  }

  /// @return its number.
  std::uint32_t keep_tile() {
    distances_cm_.push_back(tile_.distances_cm());
    SurfaceTiles::CoarseDistances& coarse = coarse_cm_.emplace_back();
    coarse.fill(SurfaceTile::kFar_cm);
    for (unsigned j = 0; j < SurfaceTile::kSide; ++j)
      for (unsigned i = 0; i < SurfaceTile::kSide; ++i) {
        std::uint8_t& least = coarse[SurfaceTiles::coarse_offset_of(i, j)];
        least = std::min(least, tile_.distances_cm()[SurfaceTile::offset_of(i, j)]);
      }
    SurfaceTiles::BlockNumbers& numbers = block_of_.emplace_back();
    for (unsigned k = 0; k < SurfaceTile::kBlocks; ++k) {
      numbers[k] = 0;
      if (!tile_.names_any(k)) continue;
      numbers[k] = static_cast<std::uint32_t>(blocks_.size());
      blocks_.push_back(tile_.block(k, names_));
    }
    return static_cast<std::uint32_t>(distances_cm_.size() - 1);
  }

  const TileLayout& layout_;
  const std::vector<NumberedShape>& shapes_;
  SurfaceTile tile_;
  std::vector<SurfaceTile::Distances> distances_cm_;
  std::vector<SurfaceTiles::CoarseDistances> coarse_cm_;
  std::vector<SurfaceTiles::BlockNumbers> block_of_;
  std::vector<NearestBlock> blocks_;
  std::vector<MapFeatureNumber> names_;
};

}  // namespace

TileLayout TileLayout::around(const Point& low, const Point& high) {
  constexpr double kMargin_m = SurfaceTile::kCap_m + SurfaceTile::kCell_m;
  TileLayout layout{low - Point::Constant(kMargin_m), 0, 0};
  const Point size = high - layout.low + Point::Constant(kMargin_m);
  layout.columns = static_cast<int>(size.x() / SurfaceTile::kTile_m) + 1;
  layout.rows = static_cast<int>(size.y() / SurfaceTile::kTile_m) + 1;
  return layout;
}

SurfaceTiles painted(const TileLayout& layout, const std::vector<NumberedShape>& shapes) {
  return Painting(layout, shapes).finished();
}

}  // namespace opal
