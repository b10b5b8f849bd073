#include "free_room.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <algorithm>
#include <limits>

namespace opal::score_free_space {
namespace {

namespace bg = boost::geometry;
using Polygon = bg::model::polygon<bg::model::d2::point_xy<double>>;
using Polygons = bg::model::multi_polygon<Polygon>;

Polygons shrunk(const std::vector<Point>& outline, double margin_m) {
  Polygon polygon;
  for (const Point& p : outline) bg::append(polygon.outer(), bg::make<bg::model::d2::point_xy<double>>(p.x(), p.y()));
  bg::correct(polygon);
  if (margin_m <= 0) return {polygon};
  Polygons smaller;
  bg::buffer(polygon, smaller, bg::strategy::buffer::distance_symmetric<double>(-margin_m),
             bg::strategy::buffer::side_straight(), bg::strategy::buffer::join_round(12),
             bg::strategy::buffer::end_flat(), bg::strategy::buffer::point_circle(12));
  return smaller;
}

template <class Ring>
void append_edges(const Ring& ring, std::vector<Segment>& edges) {
  for (std::size_t k = 1; k < ring.size(); ++k)
    edges.push_back({{ring[k - 1].x(), ring[k - 1].y()}, {ring[k].x(), ring[k].y()}});
}

}  // namespace

FreeRoom::FreeRoom(const std::vector<Point>& outline, double margin_m) {
  if (outline.size() < 3) return;
  for (const Polygon& piece : shrunk(outline, margin_m)) {
    append_edges(piece.outer(), edges_);
    for (const auto& hole : piece.inners()) append_edges(hole, edges_);
  }
  for (const Segment& edge : edges_) box_.extend(edge.begin);
}

/// Even-odd rule.
bool FreeRoom::holds(const Point& p) const {
  bool inside = false;
  for (const Segment& e : edges_)
    if ((e.begin.y() > p.y()) != (e.end.y() > p.y()) &&
        p.x() < e.begin.x() + (p.y() - e.begin.y()) / (e.end.y() - e.begin.y()) * (e.end.x() - e.begin.x()))
      inside = !inside;
  return inside;
}

double FreeRoom::depth_m(const Point& p) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& edge : edges_) nearest = std::min(nearest, distance_m(edge, p));
  return nearest;
}

std::vector<Segment> FreeRoom::inside(const Segment& segment, double depth) const {
  if (!box_.intersects(Eigen::AlignedBox2d(segment.begin).extend(segment.end))) return {};
  const Point way = segment.end - segment.begin;
  std::vector<double> cuts{0, 1};
  for (const Segment& edge : edges_) {
    const Point along = edge.end - edge.begin, to = edge.begin - segment.begin;
    const double d = cross(way, along);
    if (d == 0) continue;
    const double at = cross(to, along) / d, on = cross(to, way) / d;
    if (at > 0 && at < 1 && on >= 0 && on <= 1) cuts.push_back(at);
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<Segment> parts;
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    const Segment part{segment.begin + cuts[k - 1] * way, segment.begin + cuts[k] * way};
    if (cuts[k] > cuts[k - 1] && holds(part.midpoint()) && (depth <= 0 || depth_m(part.midpoint()) >= depth))
      parts.push_back(part);
  }
  return parts;
}

}  // namespace opal::score_free_space
