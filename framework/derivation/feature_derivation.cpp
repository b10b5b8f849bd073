#include "derivation/feature_derivation.hpp"

#include "derivation/sightings.hpp"
#include "map_tools/building_ground.hpp"
#include "map_tools/map_raster.hpp"
#include "simulation/clutter.hpp"
#include "simulation/laser.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace opal {
namespace {

using simulation::RayCaster;

// A detector's view of a thing lies on the object's surface but for what its fit is off.
constexpr double kOnObject_m = 0.3;
// What hides a thing stands farther before it than its own surface does.
constexpr double kHides_m = 0.3;

RayCaster shut_building(const SemanticMap& map) {
  Random unused(0);
  return RayCaster(simulation::building_solids(map, 0, unused));
}

/// Without the leaves of doors: an open one stands somewhere, and is no part of the building that one could rely on.
RayCaster open_building(const SemanticMap& map) {
  std::vector<MapFeature> features;
  std::copy_if(map.features().begin(), map.features().end(), std::back_inserter(features),
               [&](const MapFeature& feature) { return !is_door_leaf(map, feature); });
  std::vector<MapObject> objects = map.objects();
  for (MapObject& object : objects) object.features.clear();  // their numbers are others now
  return shut_building(*map.with_contents(objects, features, {}, {}));
}

/// All rooms, also those behind doors that are shut.
FloorGrid floor_of(const SemanticMap& map, const RayCaster& solids, double clearance_m) {
  FloorGrid floor =
      BuildingGround(map).floor([&](const Point& p) { return !solids.touches(p, clearance_m); }, FloorGrid::Parts::all);
  if (floor.cells().empty())
    throw MapError(fmt::format("{}: nowhere in it is a place {} m from every surface, from where a detector could look",
                               map.name(), clearance_m));
  return floor;
}

/// One place for each square of a grid that has floor: the floor's cell next to the square's middle.
std::vector<Point> places_to_look_from(const FloorGrid& floor, double spacing_m) {
  std::map<std::pair<int, int>, std::pair<double, Point>> by_square;
  for (const int cell : floor.cells()) {
    const Point place = floor.center_of(cell), square = (place / spacing_m).array().floor();
    const double off_m = (place - spacing_m * (square + Point(0.5, 0.5))).norm();
    const auto [at, is_new] = by_square.try_emplace({int(square.x()), int(square.y())}, off_m, place);
    if (!is_new && off_m < at->second.first) at->second = {off_m, place};
  }
  std::vector<Point> places;
  for (const auto& [square, best] : by_square) places.push_back(best.second);
  return places;
}

/// A laser without errors that sees all around.
class CleanLaser {
 public:
  CleanLaser(const RayCaster& solids, double reach_m) : solids_(solids) {
    laser_.beams = 1440;
    laser_.angle_min_rad = -std::numbers::pi;
    laser_.angle_increment_rad = 2 * std::numbers::pi / laser_.beams;
    laser_.range_max_m = reach_m;
    laser_.no_return_m = 2 * reach_m;
  }

  Scan scan_at(const Pose2& T_map_laser) const {
    constexpr simulation::LaserErrors kNone{
        .range_sigma_m = 0, .range_sigma_share = 0, .missed_share = 0, .mixed_share = 0, .glass_share = 1};
    Random unused(0);
    return make_scan(swept(
                         solids_, {}, [&](int) { return T_map_laser; }, laser_, kNone, unused),
                     laser_);
  }

 private:
  const RayCaster& solids_;
  LaserModel laser_;
};

Sightings looked_around(const std::vector<Point>& places, const CleanLaser& laser, const FeatureDetector& detector,
                        const std::set<std::string>& types, const std::function<void(double)>& progress) {
  constexpr double kTurn_rad = 2.4;  // between places, so that no side of the building is always at a scan's end
  Sightings sightings;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (progress) progress(static_cast<double>(k) / static_cast<double>(places.size()));
    const Pose2 T_map_laser(places[k], kTurn_rad * static_cast<double>(k));
    for (const Feature& seen : detector.detect(laser.scan_at(T_map_laser)))
      if (types.contains(seen.type)) sightings.add(transformed(T_map_laser, seen), places[k]);
  }
  return sightings;
}

/// From how many places a thing is in view, no farther than it was seen from.
std::size_t places_in_view(const std::vector<Point>& places, const RayCaster& solids, const Geometry& thing,
                           double farthest_m) {
  const Point anchor = anchor_of(thing);
  const auto* round = std::get_if<Circle>(&thing);
  const double before_m = kHides_m + (round ? round->radius_m : 0);
  return static_cast<std::size_t>(std::count_if(places.begin(), places.end(), [&](const Point& place) {
    const Point way = anchor - place;
    const double range_m = way.norm();
    if (range_m > farthest_m || range_m <= before_m) return range_m <= before_m;
    return solids.cast(place, way / range_m, range_m - before_m).solid < 0;
  }));
}

/// Whose surface is next to a thing; none is near: none.
MapObjectNumber object_at(const SemanticMap& map, const Geometry& thing) {
  const auto* round = std::get_if<Circle>(&thing);
  double nearest_m = kOnObject_m + (round ? round->radius_m : 0);
  MapObjectNumber object;
  for (const MapFeature& feature : map.features())
    if (const double off_m = distance_m(feature.geometry, anchor_of(thing)); off_m < nearest_m) {
      nearest_m = off_m;
      object = feature.object;
    }
  return object;
}

/// "acme:Post" is called "Post".
std::string short_name(const std::string& type) { return type.substr(type.rfind(':') + 1); }

/// Adds features to objects under names that the map does not have.
class Additions {
 public:
  Additions(const SemanticMap& map, const std::string& sensor) : map_(map), features_(map.features()), sensor_(sensor) {
    for (const MapFeature& feature : features_) ids_.insert(feature.id);
  }

  bool knows(const std::string& type, const Geometry& thing) const { return has(0, type, thing); }
  /// Whether it is one of those that were added, and the map had it not.
  bool is_new(const std::string& type, const Geometry& thing) const { return has(map_.features().size(), type, thing); }

  void add(MapObjectNumber object, const std::string& type, const Geometry& thing) {
    const std::string stem = map_.object(object).id + "/" + short_name(type) + "-";
    int number = 1;
    while (!ids_.insert(stem + std::to_string(number)).second) ++number;
    added_.push_back(stem + std::to_string(number));
    features_.push_back({added_.back(), object, type, sensor_, thing});
  }

  std::shared_ptr<const SemanticMap> map_with_all(const std::map<std::string, std::string>& prefixes) const {
    return map_.with_contents(map_.objects(), features_, map_.patterns(), prefixes);
  }
  const std::vector<std::string>& added() const { return added_; }

 private:
  bool has(std::size_t from, const std::string& type, const Geometry& thing) const {
    return std::any_of(
        features_.begin() + static_cast<std::ptrdiff_t>(from), features_.end(), [&](const auto& feature) {
          return feature.sensor == sensor_ && feature.type == type && is_one_thing(feature.geometry, thing);
        });
  }

  const SemanticMap& map_;
  std::vector<MapFeature> features_;
  std::string sensor_;
  std::set<std::string> ids_;
  std::vector<std::string> added_;
};

}  // namespace

Derivation derived_features(const SemanticMap& map, const FeatureDetector& detector, std::span<const std::string> types,
                            const DerivationOptions& options, const std::map<std::string, std::string>& prefixes) {
  const RayCaster solids = options.doors_open ? open_building(map) : shut_building(map);
  const FloorGrid floor = floor_of(map, solids, options.clearance_m);
  const std::vector<Point> places = places_to_look_from(floor, options.spacing_m);
  const Sightings seen = looked_around(places, CleanLaser(solids, options.reach_m), detector,
                                       {types.begin(), types.end()}, options.progress);
  Additions additions(map, options.sensor);
  Derivation derivation;
  derivation.places = places.size();
  for (const Sighted& thing : seen.all()) {
    const Geometry geometry = thing.geometry();
    const auto views = static_cast<double>(thing.views.size());
    const MapObjectNumber object = object_at(map, geometry);
    if (additions.knows(thing.type, geometry))
      ++(additions.is_new(thing.type, geometry) ? derivation.twice : derivation.known);
    else if (!object.exists())
      ++derivation.on_nothing;
    else if (views < options.fewest_views ||
             views < options.least_share * double(places_in_view(places, solids, geometry, thing.farthest_m)))
      ++derivation.seldom;
    else
      additions.add(object, thing.type, geometry);
  }
  derivation.map = additions.map_with_all(prefixes);
  derivation.added = additions.added();
  return derivation;
}

}  // namespace opal
