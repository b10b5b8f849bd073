#include <opal/sensing/point_runs.hpp>

#include <algorithm>

namespace opal {
namespace {

constexpr double kWidestPerson_m = 0.6;
// The second lets sparse points through: those of a far wall, seen at a grazing angle.
constexpr double kFree_m = 0.3, kFreePerRange = 0.1;

bool are_apart(const Point& a, const Point& b) {
  return (a - b).norm() > std::max(kFree_m, kFreePerRange * std::min(a.norm(), b.norm()));
}

}  // namespace

std::vector<PointRun> point_runs(std::span<const Point> points) {
  std::vector<PointRun> runs;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k == 0 || are_apart(points[k - 1], points[k])) runs.push_back({k, k + 1, false});
    runs.back().end = k + 1;
  }
  for (PointRun& run : runs) run.may_walk = (points[run.end - 1] - points[run.first]).norm() < kWidestPerson_m;
  return runs;
}

}  // namespace opal
