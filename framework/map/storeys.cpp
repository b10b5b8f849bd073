#include <opal/map/storeys.hpp>

#include "map/semantic_map_storeys.hpp"

#include <opal/map/semantic_map.hpp>

namespace opal {

const MapStorey* storey_at(const SemanticMap& map, const Point& p_map) {
  return nearest_sheet(map.origin().storeys, p_map);
}

const MapStorey* find_storey(const SemanticMap& map, const std::string& id) {
  return with_id(map.origin().storeys, id);
}

PlaceInBuilding place_in_building(const SemanticMap& map, const Pose2& T_map_base) {
  const MapStorey* storey = storey_at(map, T_map_base.position());
  if (storey == nullptr) return {"", "", T_map_base};
  return {storey->building, storey->id, storey->to_storey(T_map_base)};
}

std::string words_for(const SemanticMap& map, const PlaceInBuilding& place) {
  const MapStorey* storey = find_storey(map, place.storey);
  if (storey == nullptr) return "";
  const MapBuilding* building = with_id(map.origin().buildings, place.building);
  if (building == nullptr) return storey->label();
  return storey->label() + " of " + (building->name.empty() ? building->id : building->name);
}

Pose2 landing_on_map(const SemanticMap& map, const Landing& landing) {
  const MapStorey* storey = find_storey(map, landing.storey);
  return storey == nullptr ? landing.T_storey_landing : storey->to_map(landing.T_storey_landing);
}

}  // namespace opal
