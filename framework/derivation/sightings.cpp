#include "derivation/sightings.hpp"

#include <opal/common/quantile.hpp>

#include <algorithm>

namespace opal {
namespace {

// Clean scans place a thing within a few centimetres; two of one type are farther apart.
constexpr double kOneThing_m = 0.2, kOneThing_rad = 0.35;
// Pieces of one face: as flat as line extraction takes them for one line.
constexpr double kOneFace_m = 0.1, kOneFace_rad = 0.1;
constexpr double kCell_m = 1;

template <class T, class Number>
double median_by(const std::vector<Geometry>& views, Number number) {
  std::vector<double> values;
  for (const Geometry& view : views) values.push_back(number(std::get<T>(view)));
  return upper_median_of(std::move(values));
}

Geometry middle_of(const std::vector<Geometry>& views, const Point&) {
  return Point(median_by<Point>(views, [](const Point& p) { return p.x(); }),
               median_by<Point>(views, [](const Point& p) { return p.y(); }));
}

Geometry middle_of(const std::vector<Geometry>& views, const OrientedPoint& first) {
  const auto number = [&](auto of) { return median_by<OrientedPoint>(views, of); };
  const double turn_rad = number([&](const OrientedPoint& p) { return wrap_angle(p.heading_rad - first.heading_rad); });
  return OrientedPoint{{number([](const OrientedPoint& p) { return p.position.x(); }),
                        number([](const OrientedPoint& p) { return p.position.y(); })},
                       wrap_angle(first.heading_rad + turn_rad),
                       number([](const OrientedPoint& p) { return p.opening_rad; })};
}

Geometry middle_of(const std::vector<Geometry>& views, const Circle&) {
  const auto number = [&](auto of) { return median_by<Circle>(views, of); };
  return Circle{
      {number([](const Circle& c) { return c.center.x(); }), number([](const Circle& c) { return c.center.y(); })},
      number([](const Circle& c) { return c.radius_m; })};
}

Geometry middle_of(const std::vector<Geometry>& views, const Segment&) {
  return *std::max_element(views.begin(), views.end(), [](const Geometry& a, const Geometry& b) {
    return std::get<Segment>(a).length_m() < std::get<Segment>(b).length_m();
  });
}

bool is_one_face(const Segment& a, const Segment& b) {
  const double turn_rad = std::abs(wrap_angle(a.heading_rad() - b.heading_rad()));
  const Segment& longer = a.length_m() < b.length_m() ? b : a;
  const Segment& shorter = a.length_m() < b.length_m() ? a : b;
  const double off_m = std::abs((shorter.midpoint() - longer.midpoint()).dot(longer.normal()));
  const double gap_m = std::min(distance_m(longer, shorter.begin), distance_m(longer, shorter.end));
  return turn_rad < kOneFace_rad && off_m < kOneFace_m && gap_m < kOneThing_m;
}

}  // namespace

bool is_one_thing(const Geometry& a, const Geometry& b) {
  if (a.index() != b.index()) return false;
  if (const auto* segment = std::get_if<Segment>(&a)) return is_one_face(*segment, std::get<Segment>(b));
  if ((anchor_of(a) - anchor_of(b)).norm() > kOneThing_m) return false;
  const auto* turned = std::get_if<OrientedPoint>(&a);
  return !turned || std::abs(wrap_angle(turned->heading_rad - std::get<OrientedPoint>(b).heading_rad)) < kOneThing_rad;
}

Geometry Sighted::geometry() const {
  return std::visit([this](const auto& first) { return middle_of(views, first); }, views.front());
}

Sightings::Cell Sightings::cell_of(const Point& place) {
  return {static_cast<int>(std::floor(place.x() / kCell_m)), static_cast<int>(std::floor(place.y() / kCell_m))};
}

Sighted* Sightings::same(const Feature& seen) {
  const auto [x, y] = cell_of(anchor_of(seen.geometry));
  for (int i = x - 1; i <= x + 1; ++i)
    for (int j = y - 1; j <= y + 1; ++j) {
      const auto here = by_cell_.find({i, j});
      if (here == by_cell_.end()) continue;
      for (const std::size_t k : here->second)
        if (all_[k].type == seen.type && is_one_thing(all_[k].views.front(), seen.geometry)) return &all_[k];
    }
  return nullptr;
}

void Sightings::add(const Feature& seen, const Point& from) {
  Sighted* thing = same(seen);
  if (!thing) {
    by_cell_[cell_of(anchor_of(seen.geometry))].push_back(all_.size());
    thing = &all_.emplace_back(Sighted{seen.type, {}, 0});
  }
  thing->views.push_back(seen.geometry);
  thing->farthest_m = std::max(thing->farthest_m, (anchor_of(seen.geometry) - from).norm());
}

}  // namespace opal
