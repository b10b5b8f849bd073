#include "face_ends.hpp"

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

constexpr double kCell_m = 2;
constexpr double kFarthest = 1e9;  ///< cells from the origin: what lies beyond is in the last one

std::int64_t cell_at(double coordinate_m) {
  return static_cast<std::int64_t>(std::clamp(std::floor(coordinate_m / kCell_m), -kFarthest, kFarthest));
}

std::int64_t key_of(std::int64_t i, std::int64_t j) { return i * (std::int64_t{1} << 32) + j; }

std::int64_t key_of(const Point& p) { return key_of(cell_at(p.x()), cell_at(p.y())); }

/// In gates: 1 on the ellipse, less inside.
double gates_between(const FaceEnds::End& end, const Point& p, const EndGate& gate) {
  const Point off = p - end.position;
  return std::hypot(end.direction.dot(off) / gate.along_m, cross(end.direction, off) / gate.across_m);
}

}  // namespace

FaceEnds::FaceEnds(std::vector<End> ends) : ends_(std::move(ends)) {
  std::stable_sort(ends_.begin(), ends_.end(),
                   [](const End& a, const End& b) { return key_of(a.position) < key_of(b.position); });
  for (std::size_t k = 0; k < ends_.size(); ++k) {
    Range& range = cells_.try_emplace(key_of(ends_[k].position), Range{k, k}).first->second;
    range.end = k + 1;
  }
}

FaceEnd FaceEnds::nearest(const Point& p, const Point& direction, Tip tip, const EndGate& gate) const {
  FaceEnd best;
  if (!p.allFinite()) return best;
  const double reach_m = std::max(gate.along_m, gate.across_m), least_cosine = std::cos(gate.angle_rad);
  for (std::int64_t i = cell_at(p.x() - reach_m); i <= cell_at(p.x() + reach_m); ++i)
    for (std::int64_t j = cell_at(p.y() - reach_m); j <= cell_at(p.y() + reach_m); ++j) {
      const auto cell = cells_.find(key_of(i, j));
      if (cell == cells_.end()) continue;
      for (std::size_t k = cell->second.begin; k < cell->second.end; ++k) {
        const End& end = ends_[k];
        if (end.tip != tip || end.direction.dot(direction) < least_cosine) continue;
        const double gates = gates_between(end, p, gate);
        if (gates < best.gates) best = {end.face, end.tip, gates};
      }
    }
  return best;
}

}  // namespace opal
