#include "navigation/path.hpp"

#include <algorithm>

namespace opal::navigation {

PlaceOnPath nearest_on_path(std::span<const Point> path, const Point& p, std::size_t first, double most_m) {
  PlaceOnPath best{std::min(first, path.size() - 1), path[std::min(first, path.size() - 1)], 0, 0};
  best.off_m = (p - best.position).norm();
  double along_m = 0;
  for (std::size_t k = first; k + 1 < path.size() && along_m < most_m; ++k) {
    const Point piece = path[k + 1] - path[k];
    const double length = piece.norm();
    if (length == 0) continue;
    const double share = std::clamp(piece.dot(p - path[k]) / (length * length), 0.0, 1.0);
    const Point position = path[k] + share * piece;
    if (const double off_m = (p - position).norm(); off_m < best.off_m)
      best = {k, position, along_m + share * length, off_m};
    along_m += length;
  }
  return best;
}

Point point_along(std::span<const Point> path, double along_m) {
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const double length = (path[k + 1] - path[k]).norm();
    if (along_m < length) return path[k] + along_m / length * (path[k + 1] - path[k]);
    along_m -= length;
  }
  return path.back();
}

double length_m(std::span<const Point> path) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) length += (path[k + 1] - path[k]).norm();
  return length;
}

}  // namespace opal::navigation
