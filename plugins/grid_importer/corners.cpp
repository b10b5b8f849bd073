#include "corners.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace opal::grid_importer {
namespace {

// Doors are wider than twice this, and SLAM grids miss up to about this much of a wall at its end.
constexpr double kMaxExtension_m = 0.35;
constexpr double kMinSine = 0.4;
// Shorter faces have no direction to speak of.
constexpr double kMinArm_m = 0.25;
// Of a drawing, they have.
constexpr double kMinDrawnArm_m = 0.1;
// Cells at the ends of an extension, in cells, that are the surface's own or its smear.
constexpr double kSmear = 1.5;

struct CornerCandidate {
  Corner corner;
  long extension = 0;  // of both faces together, in 1e-4 cells: rounding must not decide between equal ones
};

/// Numbers of faces by the place of their begin.
class Begins {
 public:
  Begins(const std::vector<Face>& faces, double pitch) : pitch_(pitch) {
    for (std::size_t k = 0; k < faces.size(); ++k) buckets_[bucket(faces[k].begin)].push_back(static_cast<int>(k));
  }

  template <class Visit>
  void visit_near(const CellPoint& p, Visit&& visit) const {
    const auto [column, row] = bucket(p);
    for (int dc = -1; dc <= 1; ++dc)
      for (int dr = -1; dr <= 1; ++dr)
        if (const auto found = buckets_.find({column + dc, row + dr}); found != buckets_.end())
          for (const int face : found->second) visit(face);
  }

 private:
  std::pair<int, int> bucket(const CellPoint& p) const {
    return {static_cast<int>(std::floor(p.x() / pitch_)), static_cast<int>(std::floor(p.y() / pitch_))};
  }

  double pitch_;
  std::map<std::pair<int, int>, std::vector<int>> buckets_;
};

std::optional<CellPoint> intersection(const Line& a, const Line& b) {
  const double sine = cross(a.tangent, b.tangent);
  if (std::abs(sine) < kMinSine) return std::nullopt;
  return a.at(cross(b.through - a.through, b.tangent) / sine);
}

/// Beams crossed the way from a face's end to the corner: a cell there, and those on both sides of it, are free.
bool is_crossed(const OccupancyGrid& grid, const Line& line, const CellPoint& from, const CellPoint& to) {
  const double length = (to - from).norm();
  for (double along = kSmear; along < length - kSmear; ++along) {
    const CellPoint p = from + along / length * (to - from);
    bool free = true;
    for (const double across : {-1.0, 0.0, 1.0})
      free = free && grid.at(cell_at(p + across * line.normal())) == Occupancy::free;
    if (free) return true;
  }
  return false;
}

class CornerSearch {
 public:
  CornerSearch(const std::vector<Face>& faces, const OccupancyGrid& grid, GridKind kind)
      : faces_(faces),
        grid_(grid),
        max_extension_(grid.to_cells(kMaxExtension_m)),
        min_arm_(grid.to_cells(kind == GridKind::drawn ? kMinDrawnArm_m : kMinArm_m)) {}

  std::vector<CornerCandidate> run() const {
    const Begins begins(faces_, max_extension_);
    std::vector<CornerCandidate> found;
    for (std::size_t before = 0; before < faces_.size(); ++before)
      begins.visit_near(faces_[before].end, [&](int after) {
        if (const auto corner = candidate(static_cast<int>(before), after)) found.push_back(*corner);
      });
    std::ranges::stable_sort(found, {}, &CornerCandidate::extension);
    return found;
  }

 private:
  std::optional<CornerCandidate> candidate(int before, int after) const {
    const Face& a = faces_[static_cast<std::size_t>(before)];
    const Face& b = faces_[static_cast<std::size_t>(after)];
    if (std::min(a.length(), b.length()) < min_arm_ || (a.end - b.begin).norm() > max_extension_) return std::nullopt;
    const std::optional<CellPoint> point = intersection(a.line(), b.line());
    if (!point || !may_end_at(a, a.end, *point) || !may_end_at(b, b.begin, *point)) return std::nullopt;
    const double extension = (*point - a.end).norm() + (*point - b.begin).norm();
    return CornerCandidate{{*point, before, after}, std::lround(1e4 * extension)};
  }

  /// An end may be drawn out a little, or cut back to the corner, but not by half of its face.
  bool may_end_at(const Face& face, const CellPoint& end, const CellPoint& point) const {
    const CellPoint middle = (face.begin + face.end) / 2;
    const bool is_beyond_middle = (point - middle).dot(end - middle) > 0;
    const bool is_drawn_out = (point - middle).norm() > (end - middle).norm();
    return is_beyond_middle && (point - end).norm() <= max_extension_ &&
           !(is_drawn_out && is_crossed(grid_, face.line(), end, point));
  }

  const std::vector<Face>& faces_;
  const OccupancyGrid& grid_;
  double max_extension_;
  double min_arm_;
};

}  // namespace

std::vector<Corner> join_corners(std::vector<Face>& faces, const OccupancyGrid& grid, GridKind kind) {
  std::vector<Corner> corners;
  std::vector<bool> end_used(faces.size());
  std::vector<bool> begin_used(faces.size());
  for (const CornerCandidate& candidate : CornerSearch(faces, grid, kind).run()) {
    const auto before = static_cast<std::size_t>(candidate.corner.before);
    const auto after = static_cast<std::size_t>(candidate.corner.after);
    if (end_used[before] || begin_used[after]) continue;
    end_used[before] = begin_used[after] = true;
    corners.push_back(candidate.corner);
  }
  for (const Corner& corner : corners) {
    faces[static_cast<std::size_t>(corner.before)].end = corner.position;
    faces[static_cast<std::size_t>(corner.after)].begin = corner.position;
  }
  return corners;
}

}  // namespace opal::grid_importer
