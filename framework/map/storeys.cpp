#include <opal/map/storeys.hpp>

#include <opal/map/semantic_map.hpp>

#include <algorithm>
#include <limits>

namespace opal {
namespace {

double outside_m(const MapStorey& storey, const Point& p) {
  return (storey.bounds[0] - p).cwiseMax(p - storey.bounds[1]).cwiseMax(Point::Zero()).norm();
}

}  // namespace

const MapStorey* storey_at(const SemanticMap& map, const Point& p_map) {
  const MapStorey* nearest = nullptr;
  double least_m = std::numeric_limits<double>::infinity();
  for (const MapStorey& storey : map.origin().storeys)
    if (const double d = outside_m(storey, p_map); d < least_m) {
      least_m = d;
      nearest = &storey;
    }
  return nearest;
}

const MapStorey* find_storey(const SemanticMap& map, const std::string& id) {
  const std::vector<MapStorey>& storeys = map.origin().storeys;
  const auto found = std::find_if(storeys.begin(), storeys.end(), [&](const MapStorey& s) { return s.id == id; });
  return found == storeys.end() ? nullptr : &*found;
}

PlaceInBuilding place_in_building(const SemanticMap& map, const Pose2& T_map_base) {
  const MapStorey* storey = storey_at(map, T_map_base.position());
  if (storey == nullptr) return {"", "", T_map_base};
  return {storey->building, storey->id, storey->to_storey(T_map_base)};
}

std::string words_for(const SemanticMap& map, const PlaceInBuilding& place) {
  const MapStorey* storey = find_storey(map, place.storey);
  if (storey == nullptr) return "";
  for (const MapBuilding& building : map.origin().buildings)
    if (building.id == place.building)
      return storey->label() + " of " + (building.name.empty() ? building.id : building.name);
  return storey->label();
}

Pose2 landing_on_map(const SemanticMap& map, const Landing& landing) {
  const MapStorey* storey = find_storey(map, landing.storey);
  return storey == nullptr ? landing.T_storey_landing : storey->to_map(landing.T_storey_landing);
}

}  // namespace opal
