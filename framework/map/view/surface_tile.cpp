#include "map/view/surface_tile.hpp"

#include <algorithm>

namespace opal {
namespace {

/// Opposite faces must fall into different layers though they are never exactly antiparallel, so the border between
/// the layers lies at headings that walls of a map seldom have.
int layer_of(const Segment& segment) {
  static const Point border = unit_vector(0.35);
  return cross(border, segment.end - segment.begin) >= 0 ? 0 : 1;
}

/// Where along a segment [m] it is within the cap of a band of the map; empty if `from` is beyond `to`.
struct Part {
  double from, to;
};

Part part_near(const Segment& segment, const Point& direction, double y_low, double y_high) {
  Part part{0, segment.length_m()};
  if (std::abs(direction.y()) > 1e-9) {
    const double a = (y_low - SurfaceTile::kCap_m - segment.begin.y()) / direction.y();
    const double b = (y_high + SurfaceTile::kCap_m - segment.begin.y()) / direction.y();
    part = {std::max(part.from, std::min(a, b)), std::min(part.to, std::max(a, b))};
  }
  return part;
}

struct AxisRange {
  double low, high;
};

/// Of what is within the cap of a circle.
AxisRange range_about(double center_m, const Circle& circle) {
  const double extent_m = circle.radius_m + SurfaceTile::kCap_m;
  return {center_m - extent_m, center_m + extent_m};
}

AxisRange x_near(const Segment& segment, const Point& direction, const Part& part) {
  const double a = segment.begin.x() + part.from * direction.x(), b = segment.begin.x() + part.to * direction.x();
  return {std::min(a, b) - SurfaceTile::kCap_m, std::max(a, b) + SurfaceTile::kCap_m};
}

AxisRange y_near(const Geometry& shape) {
  if (const auto* s = std::get_if<Segment>(&shape))
    return {std::min(s->begin.y(), s->end.y()) - SurfaceTile::kCap_m,
            std::max(s->begin.y(), s->end.y()) + SurfaceTile::kCap_m};
  if (const auto* c = std::get_if<Circle>(&shape)) return range_about(c->center.y(), *c);
  return {1, 0};
}

TileSpan tiles_of(const AxisRange& range, double grid_low) {
  if (range.high < range.low) return {};
  return {static_cast<int>(std::floor((range.low - grid_low) / SurfaceTile::kTile_m)),
          static_cast<int>(std::floor((range.high - grid_low) / SurfaceTile::kTile_m))};
}

/// The cells of a tile that a range touches, by their numbers in the grid.
struct CellSpan {
  int first, last;
};

CellSpan cells_of(const AxisRange& range, double grid_low, int first_of_tile) {
  const double low = (range.low - grid_low) / SurfaceTile::kCell_m,
               high = (range.high - grid_low) / SurfaceTile::kCell_m;
  return {std::max(first_of_tile, static_cast<int>(low)),
          std::min(first_of_tile + SurfaceTile::kSide - 1, static_cast<int>(high))};
}

}  // namespace

TileSpan tile_rows_near(const Geometry& shape, const Point& grid_corner) {
  return tiles_of(y_near(shape), grid_corner.y());
}

TileSpan tile_columns_near(const Geometry& shape, const Point& grid_corner, int row) {
  if (const auto* c = std::get_if<Circle>(&shape)) return tiles_of(range_about(c->center.x(), *c), grid_corner.x());
  const auto* s = std::get_if<Segment>(&shape);
  if (s == nullptr) return {};
  const double y_low = grid_corner.y() + row * SurfaceTile::kTile_m;
  const Part part = part_near(*s, s->direction(), y_low, y_low + SurfaceTile::kTile_m);
  return part.from > part.to ? TileSpan{} : tiles_of(x_near(*s, s->direction(), part), grid_corner.x());
}

void SurfaceTile::clear(const Point& grid_corner, int column, int row) {
  grid_corner_ = grid_corner;
  i_low_ = column * kSide;
  j_low_ = row * kSide;
  is_empty_ = true;
  distances_cm_.fill(kFar_cm);
  for (auto& layer : layer_distances_cm_) layer.fill(kFar_cm);
  nearest_.fill({});
}

void SurfaceTile::paint_cell(int i, int j, double distance_m, MapFeatureNumber number, int first_layer,
                             int last_layer) {
  is_empty_ = false;
  const unsigned offset = offset_of(i - i_low_, j - j_low_);
  const auto cm = static_cast<std::uint8_t>(std::min(100 * distance_m + 0.5, 254.0));
  distances_cm_[offset] = std::min(distances_cm_[offset], cm);
  if (distance_m > kReach_m) return;
  for (int layer = first_layer; layer <= last_layer; ++layer) {
    std::uint8_t& layer_cm = layer_distances_cm_[layer][offset];
    if (cm >= layer_cm) continue;
    layer_cm = cm;
    nearest_[offset][layer] = number;
  }
}

/// Row by row, only the cells within the cap of the segment: a long diagonal wall must not cost its bounding box.
void SurfaceTile::paint(MapFeatureNumber number, const Segment& segment) {
  const int layer = layer_of(segment);
  const Point direction = segment.direction();
  const double length = segment.length_m();
  const CellSpan rows = cells_of(y_near(segment), grid_corner_.y(), j_low_);
  for (int j = rows.first; j <= rows.last; ++j) {
    const double y = center_of(0, j).y();
    const Part part = part_near(segment, direction, y, y);
    if (part.from > part.to) continue;
    const CellSpan columns = cells_of(x_near(segment, direction, part), grid_corner_.x(), i_low_);
    for (int i = columns.first; i <= columns.last; ++i) {
      const Point p = center_of(i, j);
      const double u = std::clamp(direction.dot(p - segment.begin), 0.0, length);
      const double distance = (p - segment.begin - u * direction).norm();
      if (distance <= kCap_m) paint_cell(i, j, distance, number, layer, layer);
    }
  }
}

void SurfaceTile::paint(MapFeatureNumber number, const Circle& circle) {
  const CellSpan rows = cells_of(y_near(circle), grid_corner_.y(), j_low_);
  const CellSpan columns = cells_of(range_about(circle.center.x(), circle), grid_corner_.x(), i_low_);
  for (int j = rows.first; j <= rows.last; ++j)
    for (int i = columns.first; i <= columns.last; ++i) {
      const double distance = std::abs((center_of(i, j) - circle.center).norm() - circle.radius_m);
      if (distance <= kCap_m) paint_cell(i, j, distance, number, 0, kLayers - 1);
    }
}

void SurfaceTile::paint(MapFeatureNumber number, const Geometry& shape) {
  if (const auto* segment = std::get_if<Segment>(&shape)) paint(number, *segment);
  if (const auto* circle = std::get_if<Circle>(&shape)) paint(number, *circle);
}

bool SurfaceTile::names_any(unsigned block) const {
  const auto first = nearest_.begin() + block * NearestBlock::kCells;
  return std::any_of(first, first + NearestBlock::kCells, [](const PerLayer& layers) {
    return std::any_of(layers.begin(), layers.end(), [](MapFeatureNumber number) { return number.exists(); });
  });
}

NearestBlock SurfaceTile::block(unsigned number, std::vector<MapFeatureNumber>& names) const {
  NearestBlock block;
  block.list_begin = static_cast<std::uint32_t>(names.size());
  names.emplace_back();  // of none
  for (unsigned k = 0; k < NearestBlock::kCells; ++k)
    for (int layer = 0; layer < kLayers; ++layer) {
      const MapFeatureNumber name = nearest_[number * NearestBlock::kCells + k][layer];
      const auto begin = names.begin() + block.list_begin, known = std::find(begin, names.end(), name);
      block.position[k][layer] = static_cast<std::uint8_t>(known - begin);
      if (known == names.end()) names.push_back(name);
    }
  return block;
}

}  // namespace opal
