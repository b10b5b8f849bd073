#include "body_cut.hpp"

#include "point_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace opal::ifc_importer {
namespace {

// No corner may lie in the plane: it is moved up by micrometres until none does.
constexpr double kNudge_m = 2e-6;
constexpr double kClear_m = 5e-7;
constexpr int kNudges = 50;
// Ends of an outline that are farther apart than this do not belong together.
constexpr double kSameEnd_m = 1e-5;
constexpr double kGap_m = 0.01;

template <class Visit>
void visit_points(const Body& body, Visit visit) {
  for (const Shell& shell : body.shells)
    for (const FaceLoops& face : shell)
      for (const auto& loop : face)
        for (const Point3& p : loop) visit(p);
}

double clear_height(const Body& body, double height_m) {
  for (int k = 0; k < kNudges; ++k) {
    bool is_clear = true;
    visit_points(body, [&](const Point3& p) { is_clear = is_clear && std::abs(p.z() - height_m) > kClear_m; });
    if (is_clear) return height_m;
    height_m += kNudge_m;
  }
  return height_m;
}

/// The same point for both faces of an edge, whichever way they go along it.
Point crossing(const Point3& a, const Point3& b, double height_m) {
  const bool up = a.z() < b.z();
  const Point3 &low = up ? a : b, &high = up ? b : a;
  const double t = (height_m - low.z()) / (high.z() - low.z());
  return (low + t * (high - low)).head<2>();
}

/// A flat face meets the plane in pieces of one line: between its first and second crossing, its third and fourth, ...
void cut_face(const FaceLoops& face, double height_m, std::vector<Segment>& edges) {
  std::vector<Point> crossings;
  for (const auto& loop : face)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point3 &a = loop[k], &b = loop[(k + 1) % loop.size()];
      if ((a.z() > height_m) != (b.z() > height_m)) crossings.push_back(crossing(a, b, height_m));
    }
  if (crossings.size() > 2) {
    const Point first = crossings.front();
    const Point far = *std::ranges::max_element(crossings, [&](const Point& a, const Point& b) {
      return (a - first).squaredNorm() < (b - first).squaredNorm();
    });
    const Point along = far - first;
    std::ranges::sort(crossings, [&](const Point& a, const Point& b) { return along.dot(a) < along.dot(b); });
  }
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
    if (crossings[k] != crossings[k + 1]) edges.push_back({crossings[k], crossings[k + 1]});
}

std::vector<Segment> cut_shell(const Shell& shell, double height_m) {
  std::vector<Segment> edges;
  for (const FaceLoops& face : shell) cut_face(face, height_m, edges);
  return edges;
}

/// Ends that only an odd number of edges share.
std::vector<Point> loose_ends(const std::vector<Segment>& edges) {
  PointNodes nodes(kSameEnd_m);
  std::vector<int> uses;
  for (const Segment& e : edges)
    for (const Point& p : {e.begin, e.end}) {
      const auto node = static_cast<std::size_t>(nodes.nearest_or_new(p));
      uses.resize(nodes.points().size());
      ++uses[node];
    }
  std::vector<Point> loose;
  for (std::size_t k = 0; k < uses.size(); ++k)
    if (uses[k] % 2 == 1) loose.push_back(nodes.points()[k]);
  return loose;
}

/// Closes small gaps. @return whether none is left.
bool close(std::vector<Segment>& edges) {
  std::vector<Point> loose = loose_ends(edges);
  while (!loose.empty()) {
    const Point end = loose.back();
    loose.pop_back();
    const auto nearest = std::ranges::min_element(
        loose, [&](const Point& a, const Point& b) { return (a - end).squaredNorm() < (b - end).squaredNorm(); });
    if (nearest == loose.end() || (*nearest - end).norm() > kGap_m) return false;
    edges.push_back({end, *nearest});
    loose.erase(nearest);
  }
  return true;
}

Region cut_shells(const Body& body, double height_m) {
  const double z = clear_height(body, height_m);
  std::vector<Region> parts;
  std::vector<Segment> open;
  for (const Shell& shell : body.shells) {
    std::vector<Segment> edges = cut_shell(shell, z), closed = edges;
    if (close(closed))
      parts.push_back(inside_of(std::move(closed)));
    else
      open.insert(open.end(), edges.begin(), edges.end());
  }
  if (!open.empty() && !close(open)) throw OpenSurface();
  if (!open.empty()) parts.push_back(inside_of(std::move(open)));
  std::erase_if(parts, [](const Region& part) { return part.kind == Region::Kind::nothing; });
  return combined(Region::Kind::unite, std::move(parts));
}

Region cut_half_space(const Body& body, double height_m) {
  const Point outward = body.outward.head<2>();
  const double to_plane_m = body.outward.dot(body.point) - body.outward.z() * height_m;
  Region region;
  if (outward.norm() < 1e-9) {
    region.kind = body.outward.z() * (height_m - body.point.z()) < 0 ? Region::Kind::everything : Region::Kind::nothing;
    return region;
  }
  region.kind = Region::Kind::half_plane;
  region.outward = outward.normalized();
  region.point = outward * (to_plane_m / outward.squaredNorm());
  return region;
}

Region::Kind kind_of(Body::Kind kind) {
  if (kind == Body::Kind::unite) return Region::Kind::unite;
  return kind == Body::Kind::intersect ? Region::Kind::intersect : Region::Kind::subtract;
}

}  // namespace

Region cut(const Body& body, double height_m) {
  if (body.kind == Body::Kind::shells) return cut_shells(body, height_m);
  if (body.kind == Body::Kind::half_space) return cut_half_space(body, height_m);
  std::vector<Region> operands;
  for (const Body& operand : body.operands) operands.push_back(cut(operand, height_m));
  return combined(kind_of(body.kind), std::move(operands));
}

Region cut(const std::vector<Body>& bodies, double height_m) {
  std::vector<Region> regions;
  for (const Body& body : bodies)
    if (Region region = cut(body, height_m); region.kind != Region::Kind::nothing) regions.push_back(std::move(region));
  return combined(Region::Kind::unite, std::move(regions));
}

Span span_of(const std::vector<Body>& bodies) {
  Span span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto extend = [&span](double low_m, double high_m) {
    span = {std::min(span.low_m, low_m), std::max(span.high_m, high_m)};
  };
  for (const Body& body : bodies) {
    visit_points(body, [&](const Point3& p) { extend(p.z(), p.z()); });
    if (body.kind == Body::Kind::half_space)
      extend(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
    if (body.operands.empty()) continue;
    const Span inner =
        span_of(body.kind == Body::Kind::unite ? body.operands : std::vector<Body>{body.operands.front()});
    extend(inner.low_m, inner.high_m);
  }
  return span;
}

}  // namespace opal::ifc_importer
