#include <opal/map_view.hpp>

#include "surface_grid.hpp"

#include <opal/error.hpp>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>

namespace opal {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 2, bg::cs::cartesian>;
using Box = bg::model::box<BoostPoint>;
using Entry = std::pair<Box, int>;
using RTree = bg::index::rtree<Entry, bg::index::quadratic<16>>;

struct Extent {
  Point low, high;
};

struct ExtentOf {
  Extent operator()(const Point& p) const { return {p, p}; }
  Extent operator()(const OrientedPoint& p) const { return {p.position, p.position}; }
  Extent operator()(const Segment& s) const { return {s.begin.cwiseMin(s.end), s.begin.cwiseMax(s.end)}; }
  Extent operator()(const Circle& c) const {
    const Point radius = Point::Constant(c.radius_m);
    return {c.center - radius, c.center + radius};
  }
};

Extent extent_of(const Geometry& geometry) { return std::visit(ExtentOf{}, geometry); }

Box box_of(const Extent& extent) {
  return {{extent.low.x(), extent.low.y()}, {extent.high.x(), extent.high.y()}};
}

std::vector<int> features_of(const SemanticMap& map, const std::string& sensor) {
  std::vector<int> numbers;
  for (std::size_t k = 0; k < map.features().size(); ++k)
    if (map.features()[k].sensor == sensor) numbers.push_back(static_cast<int>(k));
  if (numbers.empty())
    throw ConfigError(map.name() + ": holds no feature that sensor '" + sensor + "' can perceive");
  return numbers;
}

Extent bounds_of(const SemanticMap& map, const std::vector<int>& numbers) {
  Extent all = extent_of(map.features()[numbers.front()].geometry);
  for (int number : numbers) {
    const Extent one = extent_of(map.features()[number].geometry);
    all = {all.low.cwiseMin(one.low), all.high.cwiseMax(one.high)};
  }
  return all;
}

std::array<float, 256> nearness_by_cm() {
  constexpr double sigma_cm = 20;
  std::array<float, 256> table{};
  for (int cm = 0; cm < 255; ++cm)
    table[cm] = static_cast<float>(std::exp(-0.5 * cm * cm / (sigma_cm * sigma_cm)));
  return table;
}

/// Where a ray from `origin` along the unit vector `ray` meets a surface, as a range, or a negative number.
struct RayMeets {
  const Point& origin;
  const Point& ray;
  double target_range_m;
  double min_penetration_m;
  bool* from_behind;

  double operator()(const Segment& s) const {
    const Point normal = s.normal();
    const double slope = normal.dot(ray);
    if (std::abs(slope) < 0.02) return -1;  // grazing: the range is not defined well enough
    const double range = normal.dot(s.begin - origin) / slope;
    if (range <= 0 || range >= target_range_m) return -1;
    if ((target_range_m - range) * std::abs(slope) < min_penetration_m) return -1;
    const double along = s.direction().dot(origin + range * ray - s.begin);
    constexpr double kOvershoot_m = 0.03;
    if (along < -kOvershoot_m || along > s.length_m() + kOvershoot_m) return -1;
    *from_behind = slope > 0;
    return range;
  }
  double operator()(const Circle& c) const {
    const Point to_center = c.center - origin;
    const double along = to_center.dot(ray), aside = cross(ray, to_center);
    if (along <= 0 || std::abs(aside) >= c.radius_m) return -1;
    const double half_chord = std::sqrt(c.radius_m * c.radius_m - aside * aside);
    const double range = along - half_chord;
    if (range <= 0 || target_range_m - range < std::min(min_penetration_m, half_chord)) return -1;
    *from_behind = false;
    return range;
  }
  double operator()(const Point&) const { return -1; }
  double operator()(const OrientedPoint&) const { return -1; }
};

struct Faces {
  const Point& point;
  const Point& view;
  /// Squared distance if the surface faces the viewer, else infinity.
  double operator()(const Segment& s) const {
    if (left_of(s.end - s.begin).dot(view) >= 0) return std::numeric_limits<double>::infinity();
    return distance_m(s, point);
  }
  double operator()(const Circle& c) const { return std::abs((c.center - point).norm() - c.radius_m); }
  double operator()(const Point&) const { return std::numeric_limits<double>::infinity(); }
  double operator()(const OrientedPoint&) const { return std::numeric_limits<double>::infinity(); }
};

}  // namespace

struct MapView::Index {
  Index(const SemanticMap& map, const std::string& sensor)
      : numbers(features_of(map, sensor)), bounds(bounds_of(map, numbers)), surfaces(bounds.low, bounds.high) {
    std::vector<Entry> entries;
    for (int number : numbers) {
      const Geometry& geometry = map.features()[number].geometry;
      entries.emplace_back(box_of(extent_of(geometry)), number);
      if (const auto* segment = std::get_if<Segment>(&geometry)) surfaces.add(number, *segment);
      if (const auto* circle = std::get_if<Circle>(&geometry)) surfaces.add(number, *circle);
    }
    tree = RTree(entries);
  }

  std::vector<int> numbers;
  Extent bounds;
  SurfaceGrid surfaces;
  RTree tree;
  std::array<float, 256> nearness = nearness_by_cm();
};

MapView::MapView(std::shared_ptr<const SemanticMap> map, const std::string& sensor)
    : map_(std::move(map)), index_(std::make_unique<const Index>(*map_, sensor)) {}
MapView::~MapView() = default;

const SemanticMap& MapView::map() const { return *map_; }
const MapFeature& MapView::feature(int number) const { return map_->features()[number]; }
std::span<const int> MapView::features() const { return index_->numbers; }
std::array<Point, 2> MapView::bounds() const { return {index_->bounds.low, index_->bounds.high}; }

std::vector<int> MapView::within(const Point& p, double radius_m) const {
  const Point radius = Point::Constant(radius_m);
  std::vector<int> found;
  const auto near_enough = [&](const Entry& e) {
    return distance_m(feature(e.second).geometry, p) <= radius_m;
  };
  const auto query =
      bg::index::intersects(box_of({p - radius, p + radius})) && bg::index::satisfies(near_enough);
  for (auto it = index_->tree.qbegin(query); it != index_->tree.qend(); ++it) found.push_back(it->second);
  return found;
}

int MapView::nearest_facing(const Point& p, const Point& view_direction) const {
  const auto candidates = index_->surfaces.nearest(p);
  int best = -1;
  double best_distance = std::numeric_limits<double>::infinity();
  for (int number : candidates) {
    if (number < 0) continue;
    const double distance = std::visit(Faces{p, view_direction}, feature(number).geometry);
    if (distance >= best_distance) continue;
    best = number;
    best_distance = distance;
  }
  return best;
}

double MapView::clearance_m(const Point& p) const {
  const auto cm = index_->surfaces.distance_cm(p);
  return cm == 255 ? clearance_cap_m() : 0.01 * cm;
}

float MapView::nearness(const Point& p) const { return index_->nearness[index_->surfaces.distance_cm(p)]; }

MapView::Crossing MapView::first_crossing(const Point& origin, const Point& target,
                                          double min_penetration_m) const {
  const Point way = target - origin;
  const double length = way.norm();
  if (!(length > 0)) return {};
  const Point ray = way / length;
  constexpr double kStep_m = 0.09;  // just below a cell
  constexpr double kNear_m = 0.12;  // a surface through a cell is at most 0.07 m from the cell's centre
  for (double range = 0; range < length;) {
    const Point p = origin + range * ray;
    const double clearance = clearance_m(p);
    if (clearance > kNear_m) {
      range += std::max(kStep_m, clearance - 0.07);
      continue;
    }
    for (int number : index_->surfaces.nearest(p)) {
      if (number < 0) continue;
      bool from_behind = false;
      const double meets =
          std::visit(RayMeets{origin, ray, length, min_penetration_m, &from_behind}, feature(number).geometry);
      if (meets > 0) return {number, meets, from_behind};
    }
    range += kStep_m;
  }
  return {};
}

}  // namespace opal
