#include "area_walls.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace opal::geojson_importer {
namespace {

// A vertex that lies so near to the line between its neighbours is none: plans have one at every door.
constexpr double kStraight_m = 0.01;
// Borders of neighbours that are drawn apart or across each other by so much are one border.
constexpr double kSameBorder_m = 0.1;
constexpr double kParallelSine = 0.17;  // 10 degrees
constexpr double kShortest_m = 0.02;

bool is_straight(const Point& before, const Point& p, const Point& after) {
  const double length_m = (after - before).norm();
  if (length_m < kStraight_m) return false;
  const Point along = (after - before) / length_m;
  const double place = along.dot(p - before);
  return std::abs(cross(along, p - before)) < kStraight_m && place > 0 && place < length_m;
}

/// Without vertices on straight lines.
Ring with_corners_only(const Ring& ring) {
  Ring corners;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point& before = corners.empty() ? ring.back() : corners.back();
    if (!is_straight(before, ring[k], ring[(k + 1) % ring.size()])) corners.push_back(ring[k]);
  }
  while (corners.size() > 3 && is_straight(corners.back(), corners.front(), corners[1])) corners.erase(corners.begin());
  return corners;
}

template <class Visit>
void visit_edges(const Area& area, Visit&& visit) {
  for (const auto& polygon : area.polygons)
    for (const Ring& ring : polygon)
      for (std::size_t k = 0; k < ring.size(); ++k) visit(Segment{ring[k], ring[(k + 1) % ring.size()]});
}

/// An area that is open to corridors.
class OpenArea {
 public:
  explicit OpenArea(const Area& area) {
    visit_edges(area, [&](const Segment& edge) {
      box_.extend(edge.begin);
      edges_.push_back(edge);
    });
  }

  bool is_near(const Segment& line) const {
    const Point low = line.begin.cwiseMin(line.end), high = line.begin.cwiseMax(line.end);
    const Point margin = Point::Constant(kSameBorder_m);
    return ((low - margin).array() <= box_.max().array()).all() &&
           ((high + margin).array() >= box_.min().array()).all();
  }

  /// Where along a line something of the area begins or ends.
  void add_places(const Segment& line, std::vector<double>& places) const {
    const Point along = line.direction();
    for (const Segment& edge : edges_) {
      for (const Point& p : {edge.begin, edge.end})
        if (std::abs(cross(along, p - line.begin)) < 2 * kSameBorder_m) places.push_back(along.dot(p - line.begin));
      const double from = cross(along, edge.begin - line.begin), to = cross(along, edge.end - line.begin);
      if (from * to >= 0) continue;
      const Point crossing = edge.begin + from / (from - to) * (edge.end - edge.begin);
      places.push_back(along.dot(crossing - line.begin));
    }
  }

  /// Whether the area lies at a place, or has its border there, in the direction of a line.
  bool is_at(const Point& p, const Point& along) const {
    bool is_inside = false;
    for (const Segment& edge : edges_) {
      if (has_border(edge, p, along)) return true;
      is_inside ^= is_crossed_by_ray(edge, p);
    }
    return is_inside;
  }

 private:
  static bool has_border(const Segment& edge, const Point& p, const Point& along) {
    const double length_m = edge.length_m();
    if (length_m < kShortest_m || std::abs(cross(edge.direction(), along)) > kParallelSine) return false;
    const double place = edge.direction().dot(p - edge.begin);
    return place >= 0 && place <= length_m && std::abs(cross(edge.direction(), p - edge.begin)) < kSameBorder_m;
  }

  std::vector<Segment> edges_;
  Eigen::AlignedBox2d box_;
};

/// The pieces of a corridor's border where no other open area is.
std::vector<Segment> closed_pieces(const Segment& line, const std::vector<const OpenArea*>& others) {
  const double length_m = line.length_m();
  std::vector<double> places{0, length_m};
  for (const OpenArea* other : others) other->add_places(line, places);
  std::ranges::sort(places);
  std::vector<Segment> pieces;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const double from = std::max(0.0, places[k]), to = std::min(length_m, places[k + 1]);
    if (to - from < 1e-6) continue;
    const Point middle = line.begin + (from + to) / 2 * line.direction();
    if (std::ranges::any_of(others, [&](const OpenArea* other) { return other->is_at(middle, line.direction()); }))
      continue;
    const Segment piece{line.begin + from * line.direction(), line.begin + to * line.direction()};
    if (!pieces.empty() && (pieces.back().end - piece.begin).norm() < 1e-6)
      pieces.back().end = piece.end;
    else
      pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace

std::vector<AreaWall> walls_around(const std::vector<Area>& areas) {
  std::vector<Area> simple = areas;
  for (Area& area : simple)
    for (auto& polygon : area.polygons)
      for (Ring& ring : polygon) ring = with_corners_only(ring);
  std::vector<std::pair<std::size_t, OpenArea>> open;
  for (std::size_t k = 0; k < simple.size(); ++k)
    if (simple[k].kind != Area::Kind::room) open.emplace_back(k, OpenArea(simple[k]));
  std::vector<AreaWall> walls;
  for (std::size_t k = 0; k < simple.size(); ++k) {
    if (simple[k].kind == Area::Kind::open) continue;
    visit_edges(simple[k], [&](const Segment& edge) {
      if (edge.length_m() < kStraight_m) return;
      std::vector<const OpenArea*> others;
      for (const auto& [number, area] : open)
        if (simple[k].kind == Area::Kind::corridor && number != k && area.is_near(edge)) others.push_back(&area);
      for (const Segment& piece : closed_pieces(edge, others))
        if (piece.length_m() >= kShortest_m || others.empty()) walls.push_back({static_cast<int>(k), piece});
    });
  }
  return walls;
}

}  // namespace opal::geojson_importer
