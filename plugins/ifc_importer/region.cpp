#include "region.hpp"

#include "line_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace opal::ifc_importer {
namespace {

// Far below what a drawing means, far above rounding.
constexpr double kSamePoint_m = 1e-4;
constexpr double kBesides_m = 4e-5;
constexpr std::size_t kCircleCorners = 16;
constexpr double kRoundness = 2e-3;  // of the radius

void collect(const Region& region, std::vector<Segment>& edges, std::vector<const Region*>& half_planes) {
  edges.insert(edges.end(), region.edges.begin(), region.edges.end());
  if (region.kind == Region::Kind::half_plane) half_planes.push_back(&region);
  for (const Region& operand : region.operands) collect(operand, edges, half_planes);
}

/// All lines that a border may run along. Half-planes are of interest near the rest only.
std::vector<Segment> candidate_lines(const Region& region) {
  std::vector<Segment> edges;
  std::vector<const Region*> half_planes;
  collect(region, edges, half_planes);
  if (edges.empty()) return edges;
  Box box;
  for (const Segment& e : edges) box.extend(e.begin).extend(e.end);
  const double reach = box.diagonal().norm() + 1;
  for (const Region* half : half_planes) {
    const Point along = left_of(half->outward), foot = half->point + along * along.dot(box.center() - half->point);
    edges.push_back({foot - reach * along, foot + reach * along});
  }
  return edges;
}

bool is_between(const Point& a, const Point& p, const Point& b) {
  return std::abs(cross((b - a).normalized(), p - a)) < kSamePoint_m && (p - a).dot(b - p) > 0;
}

/// Corners that lie on the way between their neighbours say nothing.
Loop without_flat_corners(const Loop& loop) {
  Loop kept;
  const std::size_t n = loop.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Point& before = kept.empty() ? loop[(k + n - 1) % n] : kept.back();
    if (!is_between(before, loop[k], loop[(k + 1) % n])) kept.push_back(loop[k]);
  }
  while (kept.size() > 3 && is_between(kept.back(), kept.front(), kept[1])) kept.erase(kept.begin());
  return kept;
}

}  // namespace

bool Region::contains(const Point& p) const {
  const auto holds = [&p](const Region& operand) { return operand.contains(p); };
  switch (kind) {
    case Kind::nothing: return false;
    case Kind::everything: return true;
    case Kind::inside: return box.contains(p) && is_within(edges, p);
    case Kind::half_plane: return outward.dot(p - point) < 0;
    case Kind::unite: return std::any_of(operands.begin(), operands.end(), holds);
    case Kind::intersect: return std::all_of(operands.begin(), operands.end(), holds);
    case Kind::subtract: return holds(operands.front()) && std::none_of(operands.begin() + 1, operands.end(), holds);
  }
  return false;
}

Region inside_of(std::vector<Segment> edges) {
  if (edges.empty()) return {};
  Region region;
  region.kind = Region::Kind::inside;
  region.edges = std::move(edges);
  for (const Segment& e : region.edges) region.box.extend(e.begin).extend(e.end);
  return region;
}

Region combined(Region::Kind kind, std::vector<Region> operands) {
  if (operands.empty()) return {};
  if (operands.size() == 1) return std::move(operands.front());
  Region region;
  region.kind = kind;
  region.operands = std::move(operands);
  return region;
}

std::vector<Loop> border_of(const Region& region) {
  const LineMesh mesh(candidate_lines(region), kSamePoint_m);
  std::vector<LineMesh::Edge> border;
  for (const LineMesh::Edge& edge : mesh.edges()) {
    const Segment s = mesh.segment(edge);
    const Point beside = kBesides_m * s.normal();
    const bool left = region.contains(s.midpoint() + beside), right = region.contains(s.midpoint() - beside);
    if (left != right) border.push_back(left ? LineMesh::Edge{edge.from, edge.to} : LineMesh::Edge{edge.to, edge.from});
  }
  std::vector<Loop> loops;
  for (const std::vector<std::size_t>& chain : closed_chains(mesh, border)) {
    Loop loop;
    for (const std::size_t edge : chain) loop.push_back(mesh.segment(border[edge]).begin);
    loop = without_flat_corners(loop);
    if (loop.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

Region inside_of(const std::vector<Loop>& loops) { return inside_of(segments_of(loops)); }

double area_m2(const Loop& loop) {
  double twice = 0;
  for (std::size_t k = 0; k < loop.size(); ++k)
    twice += cross(loop[k] - loop[0], loop[(k + 1) % loop.size()] - loop[0]);
  return twice / 2;
}

Box box_of(const Loop& loop) {
  Box box;
  for (const Point& p : loop) box.extend(p);
  return box;
}

std::vector<Segment> segments_of(const std::vector<Loop>& loops) {
  std::vector<Segment> segments;
  for (const Loop& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) segments.push_back({loop[k], loop[(k + 1) % loop.size()]});
  return segments;
}

std::optional<Circle> circle_of(const Loop& loop) {
  if (loop.size() < kCircleCorners) return std::nullopt;
  Point center = Point::Zero();
  for (const Point& p : loop) center += p / static_cast<double>(loop.size());
  double radius = 0;
  for (const Point& p : loop) radius += (p - center).norm() / static_cast<double>(loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Point& next = loop[(k + 1) % loop.size()];
    if (std::abs((loop[k] - center).norm() - radius) > kRoundness * radius) return std::nullopt;
    if ((next - loop[k]).norm() > 2 * radius * std::sin(std::numbers::pi / (kCircleCorners - 4))) return std::nullopt;
  }
  return Circle{center, radius};
}

}  // namespace opal::ifc_importer
