#include "face_ends.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace opal::score_beams {
namespace {

/// In gates: 1 on the ellipse, less inside.
double gates_between(const FaceEnds::End& end, const Point& p, const EndGate& gate) {
  const Point off = p - end.position;
  return std::hypot(end.direction.dot(off) / gate.along_m, cross(end.direction, off) / gate.across_m);
}

/// 2 m, or more in a map so wide that there would be too many of them.
double cell_for(const Point& size_m) {
  constexpr double kCell_m = 2, kMostCells = 1 << 22, kMostInARow = 1 << 20;
  return std::max({kCell_m, std::sqrt(size_m.prod() / kMostCells), size_m.maxCoeff() / kMostInARow});
}

/// What lies outside is in the nearest one.
int cell_at(double offset_m, double cell_m, int cells) {
  return static_cast<int>(std::clamp(std::floor(offset_m / cell_m), 0.0, cells - 1.0));
}

/// Whether another face that looks to the same side carries on where this one ends.
bool goes_on(const MapView& map, MapFeatureNumber number, const Point& end, const Point& outwards) {
  constexpr double kBeyond_m = 0.3, kBeside_m = 0.15, kRounding_m = 0.01, kLeastCosine = 0.97;
  const Point beyond = end + kBeyond_m * outwards;
  const std::vector<MapFeatureNumber> near = map.within(beyond, kBeside_m + kRounding_m);
  return std::any_of(near.begin(), near.end(), [&](MapFeatureNumber number_there) {
    const Surface& other = map.surface(number_there);
    return number_there != number && other.direction.dot(map.surface(number).direction) > kLeastCosine &&
           other.distance_m(beyond) <= kBeside_m;
  });
}

}  // namespace

FaceEnds FaceEnds::of(const MapView& map) {
  std::vector<End> found;
  for (MapFeatureNumber number : map.features()) {
    const Surface& face = map.surface(number);
    if (face.is_circle()) continue;
    const Point end = face.origin + face.size_m * face.direction;
    if (!goes_on(map, number, face.origin, -face.direction))
      found.push_back({face.origin, face.direction, number, Tip::begin});
    if (!goes_on(map, number, end, face.direction)) found.push_back({end, face.direction, number, Tip::end});
  }
  return FaceEnds(std::move(found));
}

FaceEnds::FaceEnds(std::vector<End> ends) : ends_(std::move(ends)) {
  if (ends_.empty()) return;
  ends_.shrink_to_fit();
  Eigen::AlignedBox2d box;
  for (const End& end : ends_) box.extend(end.position);
  low_ = box.min();
  const Point size_m = box.sizes() + Point::Ones();
  cell_m_ = cell_for(size_m);
  columns_ = static_cast<int>(size_m.x() / cell_m_) + 1;
  rows_ = static_cast<int>(size_m.y() / cell_m_) + 1;
  std::stable_sort(ends_.begin(), ends_.end(),
                   [&](const End& a, const End& b) { return cell_of(a.position) < cell_of(b.position); });
  first_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  for (const End& end : ends_) ++first_[cell_of(end.position) + 1];
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
}

int FaceEnds::column_of(double x_m) const { return cell_at(x_m - low_.x(), cell_m_, columns_); }
int FaceEnds::row_of(double y_m) const { return cell_at(y_m - low_.y(), cell_m_, rows_); }

std::size_t FaceEnds::cell_of(const Point& p) const {
  return static_cast<std::size_t>(row_of(p.y())) * columns_ + column_of(p.x());
}

FaceEnd FaceEnds::nearest(const Point& p, const Point& direction, Tip tip, const EndGate& gate) const {
  FaceEnd best;
  if (ends_.empty() || !p.allFinite()) return best;
  const double reach_m = std::max(gate.along_m, gate.across_m), least_cosine = std::cos(gate.angle_rad);
  const int from = column_of(p.x() - reach_m), to = column_of(p.x() + reach_m), last_row = row_of(p.y() + reach_m);
  for (int row = row_of(p.y() - reach_m); row <= last_row; ++row) {
    const std::size_t before = static_cast<std::size_t>(row) * columns_;
    for (std::uint32_t k = first_[before + from]; k < first_[before + to + 1]; ++k) {
      const End& end = ends_[k];
      if (end.tip != tip || end.direction.dot(direction) < least_cosine) continue;
      const double gates = gates_between(end, p, gate);
      if (gates < best.gates) best = {end.face, end.tip, gates};
    }
  }
  return best;
}

}  // namespace opal::score_beams
