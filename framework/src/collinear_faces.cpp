#include "collinear_faces.hpp"

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

constexpr double kOff_m = 0.2, kOff_rad = 0.15, kBeyond_m = 30;

Point middle(const Surface& face) { return face.origin + 0.5 * face.size_m * face.direction; }

bool lies_on(const Surface& line, const Surface& face) {
  const Point from = middle(face) - line.origin;
  const double along = line.direction.dot(from);
  return line.direction.dot(face.direction) > std::cos(kOff_rad) && std::abs(line.normal().dot(from)) < kOff_m &&
         along > -kBeyond_m && along < line.size_m + kBeyond_m;
}

/// Surfaces with a size, longest first.
std::vector<int> longest_first(const std::vector<Surface>& surfaces) {
  std::vector<int> order;
  for (std::size_t k = 0; k < surfaces.size(); ++k)
    if (surfaces[k].size_m > 0) order.push_back(static_cast<int>(k));
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return surfaces[a].size_m > surfaces[b].size_m; });
  return order;
}

}  // namespace

void number_lines(std::vector<Surface>& surfaces, const SurfacesInBox& in_box) {
  for (int first : longest_first(surfaces)) {
    Surface& line = surfaces[first];
    if (line.line >= 0) continue;
    line.line = first;
    if (line.is_circle()) continue;
    const Point begin = line.origin - kBeyond_m * line.direction;
    const Point end = line.origin + (line.size_m + kBeyond_m) * line.direction;
    const Point around = Point::Constant(kOff_m);
    for (int other : in_box(begin.cwiseMin(end) - around, begin.cwiseMax(end) + around)) {
      Surface& face = surfaces[other];
      if (face.line < 0 && face.size_m > 0 && !face.is_circle() && lies_on(line, face)) face.line = first;
    }
  }
}

}  // namespace opal
