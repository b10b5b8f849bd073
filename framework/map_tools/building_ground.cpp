#include "map_tools/building_ground.hpp"

#include "map_tools/building_outside.hpp"

namespace opal {

std::optional<Segment> leaf_of(const SemanticMap& map, const MapObject& object) {
  std::optional<Segment> longest;
  for (const MapFeatureNumber number : object.features) {
    const MapFeature& feature = map.feature(number);
    const auto* piece = std::get_if<Segment>(&feature.geometry);
    if (!piece || !is_door_leaf(map, feature)) continue;
    if (!longest || piece->length_m() > longest->length_m()) longest = *piece;
  }
  return longest;
}

BuildingGround::BuildingGround(const SemanticMap& map, bool outdoors)
    : raster_(floor_raster(map)),
      outside_(outdoors ? std::vector<char>(raster_.cells.size(), 0) : outside_cells(map, raster_)) {}

bool BuildingGround::is_outside(const Point& p) const {
  const Point cell = (p - raster_.origin) / raster_.resolution_m;
  if (!(cell.x() >= 0 && cell.y() >= 0 && cell.x() < raster_.columns && cell.y() < raster_.rows)) return false;
  return outside_[static_cast<std::size_t>(cell.y()) * raster_.columns + static_cast<std::size_t>(cell.x())] != 0;
}

bool BuildingGround::is_shut_outer_door(const SemanticMap& map, const MapObject& object) const {
  const auto leaf = leaf_of(map, object);
  if (!leaf || !(leaf->length_m() > 0)) return false;
  const Point middle = 0.5 * (leaf->begin + leaf->end);
  for (const double off_m : {-0.8, -0.5, 0.5, 0.8})  // beyond the wall's thickness
    if (is_outside(middle + off_m * leaf->normal())) return true;
  return false;
}

FloorGrid BuildingGround::floor(const std::function<bool(const Point&)>& has_room, FloorGrid::Parts parts) const {
  return seen_floor(
      raster_, [&](const Point& p) { return !is_outside(p) && has_room(p); }, parts);
}

FloorGrid BuildingGround::floor_with_outside(const std::function<bool(const Point&)>& has_room) const {
  FloorGrid floor = seen_floor(raster_, has_room, FloorGrid::Parts::all);
  floor.close_off(outside_);
  return floor;
}

}  // namespace opal
