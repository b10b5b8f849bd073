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

struct Candidate {
  Corner corner;
  double extension = 0;  // of both faces together
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

std::optional<Candidate> candidate(const std::vector<Face>& faces, int before, int after, double max_extension) {
  const Face& a = faces[static_cast<std::size_t>(before)];
  const Face& b = faces[static_cast<std::size_t>(after)];
  if ((a.end - b.begin).norm() > max_extension) return std::nullopt;
  const std::optional<CellPoint> point = intersection(a.line(), b.line());
  if (!point) return std::nullopt;
  const double from_a = (*point - a.end).norm();
  const double from_b = (*point - b.begin).norm();
  // An end may be cut back to the corner, but not by half of its face.
  if (std::max(from_a, from_b) > max_extension || a.line().along(*point) < 0.5 * a.length() ||
      b.line().along(*point) > 0.5 * b.length())
    return std::nullopt;
  return Candidate{{*point, before, after}, from_a + from_b};
}

std::vector<Candidate> candidates(const std::vector<Face>& faces, double resolution_m) {
  const double max_extension = kMaxExtension_m / resolution_m;
  const double min_arm = kMinArm_m / resolution_m;
  const Begins begins(faces, max_extension);
  std::vector<Candidate> found;
  for (std::size_t before = 0; before < faces.size(); ++before) {
    if (faces[before].length() < min_arm) continue;
    begins.visit_near(faces[before].end, [&](int after) {
      if (faces[static_cast<std::size_t>(after)].length() < min_arm) return;
      if (const auto corner = candidate(faces, static_cast<int>(before), after, max_extension)) found.push_back(*corner);
    });
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.extension < b.extension; });
  return found;
}

}  // namespace

std::vector<Corner> join_corners(std::vector<Face>& faces, double resolution_m) {
  std::vector<Corner> corners;
  std::vector<bool> end_used(faces.size());
  std::vector<bool> begin_used(faces.size());
  for (const Candidate& candidate : candidates(faces, resolution_m)) {
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
