#include "map_tools/map_join.hpp"

#include "common/phrases.hpp"

#include <opal/common/error.hpp>

#include <numbers>

namespace opal {
namespace {

/// Applies a placement to one shape.
class Placing {
 public:
  explicit Placing(const MapPlacement& placement)
      : placement_(placement), mirrored_(placement.scale.x() * placement.scale.y() < 0) {}

  Geometry operator()(const Point& p) const { return placement_.to_map(p); }
  Geometry operator()(const Segment& s) const {
    const Point begin = placement_.to_map(s.begin), end = placement_.to_map(s.end);
    return mirrored_ ? Segment{end, begin} : Segment{begin, end};
  }
  Geometry operator()(const Circle& c) const {
    const double mean = std::sqrt(std::abs(placement_.scale.x() * placement_.scale.y()));
    return Circle{placement_.to_map(c.center), mean * c.radius_m};
  }
  Geometry operator()(const OrientedPoint& corner) const {
    if (placement_.is_rigid())
      return OrientedPoint{placement_.to_map(corner.position),
                           wrap_angle(corner.heading_rad + placement_.T_map_source.heading_rad()), corner.opening_rad};
    const double half_rad = corner.opening_rad / 2;
    double right_rad = turned(corner.heading_rad - half_rad), left_rad = turned(corner.heading_rad + half_rad);
    if (mirrored_) std::swap(right_rad, left_rad);
    double opening_rad = wrap_angle(left_rad - right_rad);
    if (opening_rad <= 0) opening_rad += 2 * std::numbers::pi;
    return OrientedPoint{placement_.to_map(corner.position), wrap_angle(right_rad + opening_rad / 2), opening_rad};
  }

 private:
  double turned(double heading_rad) const {
    const Point v = placement_.to_map(unit_vector(heading_rad)) - placement_.to_map(Point::Zero());
    return std::atan2(v.y(), v.x());
  }

  const MapPlacement& placement_;
  bool mirrored_;
};

}  // namespace

Geometry placed(const MapPlacement& placement, const Geometry& geometry) {
  return std::visit(Placing(placement), geometry);
}

ObjectNotes placed(const MapPlacement& placement, ObjectNotes notes) {
  if (notes.axis) notes.axis = Segment{placement.to_map(notes.axis->begin), placement.to_map(notes.axis->end)};
  return notes;
}

const MapPlacement& placement_of(const SemanticMap& map, const std::string& id) {
  const auto& placements = map.origin().placements;
  for (const MapPlacement& placement : placements)
    if (placement.id == id) return placement;
  throw ConfigError(map.name() + ": no placement '" + id +
                    "', expected one of: " + (placements.empty() ? "none" : listed_by(placements, &MapPlacement::id)));
}

}  // namespace opal
