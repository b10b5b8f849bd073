#include "hit_chance.hpp"

#include <algorithm>
#include <cmath>

using opal::Point;

namespace {

// Both faces of one wall in 3 m x 3 m: what the weights of the evidence were fitted to.
constexpr double kUsualChance = 0.067;
constexpr double kMostChance = 0.95;
constexpr double kShareThatFaces = 0.5;

/// By cell, per area [m / m2]: each face in pieces, each in the cell of its middle.
std::vector<float> faces_in(const opal::MapView& map, const MapCells& cells) {
  constexpr double kPiece_m = 0.25;
  std::vector<float> faces(cells.count(), 0);
  for (opal::MapFeatureNumber number : map.features()) {
    const opal::Surface& face = map.surface(number);
    if (face.is_circle()) continue;
    const int pieces = 1 + static_cast<int>(face.size_m / kPiece_m);
    const double length_m = face.size_m / pieces;
    for (int k = 0; k < pieces; ++k)
      faces[cells.cell_of(face.origin + (k + 0.5) * length_m * face.direction)] +=
          static_cast<float>(length_m / (cells.cell_m() * cells.cell_m()));
  }
  return faces;
}

/// Mean of a cell and its eight neighbours; nothing is drawn outside the map.
float mean_around(const std::vector<float>& values, const MapCells& cells, int column, int row) {
  float sum = 0;
  for (int r = std::max(0, row - 1); r <= std::min(cells.rows() - 1, row + 1); ++r)
    for (int c = std::max(0, column - 1); c <= std::min(cells.columns() - 1, column + 1); ++c)
      sum += values[cells.number(c, r)];
  return sum / 9;
}

}  // namespace

HitChance::HitChance(const opal::MapView& map, double reach_m) : reach_m_(reach_m) {
  constexpr double kCell_m = 1;
  const auto [low, high] = map.bounds();
  if (map.features().empty()) return;
  cells_ = MapCells(low, high, kCell_m);
  const std::vector<float> faces = faces_in(map, cells_);
  faces_per_m_.reserve(faces.size());
  for (int row = 0; row < cells_.rows(); ++row)
    for (int column = 0; column < cells_.columns(); ++column)
      faces_per_m_.push_back(mean_around(faces, cells_, column, row));
}

double HitChance::surprise(const Point& p) const {
  if (faces_per_m_.empty() || !p.allFinite()) return 1;
  const double chance =
      std::clamp(kShareThatFaces * reach_m_ * faces_per_m_[cells_.cell_of(p)], kUsualChance, kMostChance);
  return std::log(chance) / std::log(kUsualChance);
}
