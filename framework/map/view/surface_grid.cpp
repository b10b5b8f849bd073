#include "map/view/surface_grid.hpp"

#include <algorithm>

namespace opal {
namespace {

constexpr double kCap_m = 2.5;
constexpr std::uint8_t kFar_cm = 255;

/// Opposite faces must fall into different layers though they are never exactly antiparallel, so the border between
/// the layers lies at headings that walls of a map seldom have.
int layer_of(const Segment& segment) {
  static const Point border = unit_vector(0.35);
  return cross(border, segment.end - segment.begin) >= 0 ? 0 : 1;
}

}  // namespace

/// What is only known while surfaces are painted: how far each layer's nearest one is, by tile.
struct SurfaceGrid::Painting {
  using LayerDistances = std::array<std::array<std::uint8_t, kCells>, kLayers>;
  std::vector<std::unique_ptr<LayerDistances>> layer_distance_cm;
  std::vector<std::unique_ptr<Distances>> distance_cm;
};

SurfaceGrid::SurfaceGrid(const Point& low, const Point& high, const std::vector<NumberedShape>& shapes)
    : low_(low - Point::Constant(kCap_m + kCell_m)) {
  const Point size = high - low_ + Point::Constant(kCap_m + kCell_m);
  columns_ = static_cast<int>(size.x() / (kCell_m * kSide)) + 1;
  rows_ = static_cast<int>(size.y() / (kCell_m * kSide)) + 1;
  cells_ = Point(columns_ * kSide, rows_ * kSide);
  tile_of_.assign(static_cast<std::size_t>(columns_) * rows_, 0);
  Painting painting;
  add_tile(painting);
  for (const auto& [number, shape] : shapes) {
    if (const auto* segment = std::get_if<Segment>(&shape)) paint(painting, number, *segment);
    if (const auto* circle = std::get_if<Circle>(&shape)) paint(painting, number, *circle);
  }
  distances_cm_.reserve(nearest_.size());
  for (auto& tile : painting.distance_cm) {
    distances_cm_.push_back(*tile);
    tile.reset();
  }
  make_coarse();
}

void SurfaceGrid::make_coarse() {
  coarse_cm_.resize(distances_cm_.size());
  for (std::size_t tile = 0; tile < coarse_cm_.size(); ++tile) {
    coarse_cm_[tile].fill(kFar_cm);
    for (unsigned j = 0; j < kSide; ++j)
      for (unsigned i = 0; i < kSide; ++i) {
        std::uint8_t& coarse = coarse_cm_[tile][coarse_offset_of(i, j)];
        coarse = std::min(coarse, distances_cm_[tile][offset_of(i, j)]);
      }
  }
}

std::uint32_t SurfaceGrid::add_tile(Painting& painting) {
  nearest_.push_back(std::make_unique<Nearest>());
  for (auto& layers : *nearest_.back()) layers.fill({});
  painting.layer_distance_cm.push_back(std::make_unique<Painting::LayerDistances>());
  for (auto& distances : *painting.layer_distance_cm.back()) distances.fill(kFar_cm);
  painting.distance_cm.push_back(std::make_unique<Distances>());
  painting.distance_cm.back()->fill(kFar_cm);
  return static_cast<std::uint32_t>(nearest_.size() - 1);
}

void SurfaceGrid::paint_cell(Painting& painting, int i, int j, double distance_m, MapFeatureNumber number,
                             int first_layer, int last_layer) {
  std::uint32_t& tile = tile_of_[static_cast<std::size_t>(j / kSide) * columns_ + i / kSide];
  if (tile == 0) tile = add_tile(painting);
  const unsigned offset = offset_of(i % kSide, j % kSide);
  const auto cm = static_cast<std::uint8_t>(std::min(100 * distance_m + 0.5, 254.0));
  std::uint8_t& least_cm = (*painting.distance_cm[tile])[offset];
  least_cm = std::min(least_cm, cm);
  if (distance_m > kReach_m) return;
  for (int layer = first_layer; layer <= last_layer; ++layer) {
    std::uint8_t& layer_cm = (*painting.layer_distance_cm[tile])[layer][offset];
    if (cm >= layer_cm) continue;
    layer_cm = cm;
    (*nearest_[tile])[offset][layer] = number;
  }
}

void SurfaceGrid::paint(Painting& painting, MapFeatureNumber number, const Segment& segment) {
  const int layer = layer_of(segment);
  const Point direction = segment.direction();
  const double length = segment.length_m();
  // Row by row, only the cells within the cap of this segment: a long diagonal wall must not cost its bounding box.
  const double y_low = std::min(segment.begin.y(), segment.end.y()) - kCap_m;
  const double y_high = std::max(segment.begin.y(), segment.end.y()) + kCap_m;
  const int j_low = std::max(0, static_cast<int>((y_low - low_.y()) / kCell_m));
  const int j_high = std::min(rows_ * kSide - 1, static_cast<int>((y_high - low_.y()) / kCell_m));
  for (int j = j_low; j <= j_high; ++j) {
    const double y = low_.y() + (j + 0.5) * kCell_m;
    double from = 0, to = length;  // the part of the segment within the cap of this row
    if (std::abs(direction.y()) > 1e-9) {
      const double a = (y - kCap_m - segment.begin.y()) / direction.y();
      const double b = (y + kCap_m - segment.begin.y()) / direction.y();
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    if (from > to) continue;
    const double x_a = segment.begin.x() + from * direction.x(), x_b = segment.begin.x() + to * direction.x();
    const int i_low = std::max(0, static_cast<int>((std::min(x_a, x_b) - kCap_m - low_.x()) / kCell_m));
    const int i_high =
        std::min(columns_ * kSide - 1, static_cast<int>((std::max(x_a, x_b) + kCap_m - low_.x()) / kCell_m));
    for (int i = i_low; i <= i_high; ++i) {
      const Point p(low_.x() + (i + 0.5) * kCell_m, y);
      const double u = std::clamp(direction.dot(p - segment.begin), 0.0, length);
      const double distance = (p - segment.begin - u * direction).norm();
      if (distance <= kCap_m) paint_cell(painting, i, j, distance, number, layer, layer);
    }
  }
}

void SurfaceGrid::paint(Painting& painting, MapFeatureNumber number, const Circle& circle) {
  const Point extent = Point::Constant(circle.radius_m + kCap_m);
  const Point low = (circle.center - extent - low_) / kCell_m, high = (circle.center + extent - low_) / kCell_m;
  for (int j = std::max(0, int(low.y())); j <= std::min(rows_ * kSide - 1, int(high.y())); ++j)
    for (int i = std::max(0, int(low.x())); i <= std::min(columns_ * kSide - 1, int(high.x())); ++i) {
      const Point p = low_ + kCell_m * Point(i + 0.5, j + 0.5);
      const double distance = std::abs((p - circle.center).norm() - circle.radius_m);
      if (distance <= kCap_m) paint_cell(painting, i, j, distance, number, 0, kLayers - 1);
    }
}

}  // namespace opal
