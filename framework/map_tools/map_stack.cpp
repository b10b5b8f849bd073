#include "map_tools/map_stack.hpp"

#include "common/phrases.hpp"
#include "map/semantic_map_storeys.hpp"
#include "map_tools/map_join.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace opal {
namespace {

/// A lift or a stairwell as one storey shows it.
struct Shaft {
  std::string type, storey, name;
  Point middle_storey = Point::Zero();
  double radius_m = 0;
  bool is_used = false;
};

/// Lifts and stairs that an importer has found on one storey, for it knows no other.
std::vector<Shaft> shafts_of(std::span<const StoreyPart> parts) {
  static const std::vector<MapConnection> kNone;  // a part that is a building has its connections
  std::vector<Shaft> shafts;
  for (const StoreyPart& part : parts)
    for (const MapConnection& one : part.map->origin().storeys.empty() ? part.map->origin().connections : kNone)
      for (const Landing& landing : one.landings)
        shafts.push_back({one.type, part.id, one.name, landing.T_storey_landing.position(), one.radius_m});
  return shafts;
}

/// The shafts of other storeys above and below one, that one included; one per storey.
std::vector<Shaft*> above_each_other(std::vector<Shaft>& shafts, Shaft& first, double same_place_m) {
  std::map<std::string, Shaft*> nearest{{first.storey, &first}};
  const auto distance_m = [&](const Shaft& shaft) { return (shaft.middle_storey - first.middle_storey).norm(); };
  for (Shaft& shaft : shafts) {
    if (shaft.is_used || shaft.type != first.type || shaft.storey == first.storey) continue;
    if (distance_m(shaft) > same_place_m) continue;
    Shaft*& chosen = nearest[shaft.storey];
    if (chosen == nullptr || distance_m(shaft) < distance_m(*chosen)) chosen = &shaft;
  }
  std::vector<Shaft*> found;
  for (const auto& [storey, shaft] : nearest) found.push_back(shaft);
  return found;
}

/// "lift-1: at x 3.0, y 2.0, 4 storeys".
std::string sentence_of(const MapConnection& connection) {
  const Point at = connection.landings.front().T_storey_landing.position();
  return fmt::format("{}: at x {:.1f}, y {:.1f}, {}", connection.id, at.x(), at.y(),
                     count_of(connection.landings.size(), "storey"));
}

/// @throws MapError if a landing is far from all that lies on its storey.
void check_landings(const SemanticMap& map, const MapConnection& connection, const std::string& file) {
  for (const Landing& landing : connection.landings) {
    const MapStorey* storey = find_storey(map, landing.storey);
    const Point at = landing_on_map(map, landing).position();
    if (storey == nullptr || distance_to_box_m(storey->bounds, at) < kLeastSheetGap_m / 4) continue;
    const Point found = landing.T_storey_landing.position(), low = storey->bounds[0] - storey->origin,
                high = storey->bounds[1] - storey->origin;
    throw MapError(
        fmt::format("{}: connection '{}': a landing at x {:.1f}, y {:.1f} of '{}', expected it within {:.0f} "
                    "m of what lies there, which reaches from x {:.1f}, y {:.1f} to x {:.1f}, y {:.1f}",
                    file, connection.id, found.x(), found.y(), storey->id, kLeastSheetGap_m / 4, low.x(), low.y(),
                    high.x(), high.y()));
  }
}

/// Lifts and stairs as one map after another shows them.
class ConnectionFinder {
 public:
  ConnectionFinder(std::span<const StoreyPart> parts, const StackOptions& options)
      : shafts_(shafts_of(parts)), options_(options) {}

  std::vector<MapConnection> run(std::vector<std::string>& report) {
    for (Shaft& shaft : shafts_)
      if (!shaft.is_used) connect(shaft, report);
    return std::move(found_);
  }

 private:
  void connect(Shaft& first, std::vector<std::string>& report) {
    const std::string word = first.type == "opal:Lift" ? "lift" : "stairs";
    const std::vector<Shaft*> all = above_each_other(shafts_, first, options_.same_place_m);
    if (all.size() < 2) {
      if (word == "lift") ++lonely_[first.storey];
      if (word == "lift" && lonely_[first.storey] == 1)
        report.push_back(fmt::format("doubtful: a lift at x {:.1f}, y {:.1f} of '{}' has none above or below it",
                                     first.middle_storey.x(), first.middle_storey.y(), first.storey));
      return;
    }
    MapConnection connection{fmt::format("{}-{}", word, ++count_[word]), first.type, first.name, first.radius_m};
    for (Shaft* shaft : all) {
      shaft->is_used = true;
      connection.radius_m = std::min(connection.radius_m, shaft->radius_m);
      connection.landings.push_back({shaft->storey, Pose2(shaft->middle_storey, 0)});
    }
    report.push_back(sentence_of(connection));
    found_.push_back(std::move(connection));
  }

  std::vector<Shaft> shafts_;
  const StackOptions& options_;
  std::map<std::string, int> count_, lonely_;
  std::vector<MapConnection> found_;
};

std::string with_prefix(const std::string& prefix, const std::string& id) {
  return id.empty() ? id : prefix + "/" + id;
}

/// The storeys of a part that is a building, moved to where the part lies.
void add_building(const StoreyPart& part, const Point& move, MapOrigin& origin) {
  const MapOrigin& own = part.map->origin();
  for (MapBuilding building : own.buildings) {
    building.id = with_prefix(part.id, building.id);
    origin.buildings.push_back(std::move(building));
  }
  for (MapStorey storey : own.storeys) {
    storey.id = with_prefix(part.id, storey.id);
    storey.building = with_prefix(part.id, storey.building);
    storey.origin += move;
    origin.storeys.push_back(std::move(storey));
  }
  for (MapConnection connection : own.connections) {
    connection.id = with_prefix(part.id, connection.id);
    for (Landing& landing : connection.landings) landing.storey = with_prefix(part.id, landing.storey);
    origin.connections.push_back(std::move(connection));
  }
}

void add_storey(const StoreyPart& part, const Point& move, const std::string& building, MapOrigin& origin) {
  const MapOrigin& own = part.map->origin();
  std::string name = part.name.empty() ? own.storey : part.name;
  origin.storeys.push_back({part.id, std::move(name), building, part.level_m, move});
}

/// Name and what else the parts agree on.
MapOrigin origin_of(std::span<const StoreyPart> parts, const SemanticMap& joined, const StackOptions& options) {
  MapOrigin origin;
  origin.smear_m = joined.origin().smear_m;
  origin.north_rad = parts.front().map->origin().north_rad;
  const bool any_storey = std::any_of(parts.begin(), parts.end(),
                                      [](const StoreyPart& part) { return part.map->origin().storeys.empty(); });
  if (!options.building.empty() && any_storey) origin.buildings.push_back({"building", options.building});
  const std::string building = origin.buildings.empty() ? "" : "building";
  for (const StoreyPart& part : parts) {
    const Point move = placement_of(joined, part.id).T_map_source.position();
    origin.widest_door_m = std::max(origin.widest_door_m, part.map->origin().widest_door_m);
    if (part.map->origin().north_rad != origin.north_rad) origin.north_rad.reset();
    if (part.map->origin().storeys.empty())
      add_storey(part, move, building, origin);
    else
      add_building(part, move, origin);
  }
  return origin;
}

/// By its id, or by a name that only one has; null: there is none.
const MapStorey* named_storey(const SemanticMap& map, const std::string& id_or_name) {
  if (const MapStorey* storey = find_storey(map, id_or_name)) return storey;
  const MapStorey* named = nullptr;
  for (const MapStorey& storey : map.origin().storeys) {
    if (storey.name != id_or_name) continue;
    if (named != nullptr) return nullptr;
    named = &storey;
  }
  return named;
}

}  // namespace

StackedMap stacked_map(const std::string& name, std::span<const StoreyPart> parts, const StackOptions& options) {
  if (!(options.gap_m >= kLeastSheetGap_m))
    throw ConfigError(fmt::format("stack: gap {} m, expected at least {} m", options.gap_m, kLeastSheetGap_m));
  std::vector<MapSourcePart> sources;
  for (const StoreyPart& part : parts) sources.push_back({part.id, part.map});
  const auto joined = joined_map(sources, {.gap_m = options.gap_m});
  StackedMap stacked;
  MapOrigin origin = origin_of(parts, *joined, options);
  for (MapConnection& connection : ConnectionFinder(parts, options).run(stacked.report))
    origin.connections.push_back(std::move(connection));
  stacked.map = SemanticMap::make(name, joined->objects(), joined->features(), joined->patterns(), std::move(origin));
  return stacked;
}

std::shared_ptr<const SemanticMap> storey_of_map(const SemanticMap& map, const std::string& id_or_name) {
  const MapStorey* wanted = named_storey(map, id_or_name);
  if (wanted == nullptr) {
    const std::string known = ids_of(map.origin().storeys);
    throw ConfigError(map.name() + ": no storey '" + id_or_name + "', expected " +
                      (known.empty() ? "none: the map holds no storeys" : "one of " + known));
  }
  const std::string& storey = wanted->id;
  const auto is_there = [&](const MapFeature& feature) {
    return storey_at(map, points_of(feature.geometry).front()) == wanted;
  };
  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  for (const MapObject& object : map.objects()) {
    const bool is_here =
        object.features.empty() ? object.id.starts_with(storey + "/") : is_there(map.feature(object.features.front()));
    if (!is_here) continue;
    for (const MapFeatureNumber number : object.features) {
      features.push_back(map.feature(number));
      features.back().object = MapObjectNumber(objects.size());
    }
    objects.push_back({object.id, object.type, {}, object.notes});
  }
  MapOrigin origin = map.origin();
  origin.storeys = {*wanted};
  std::erase_if(origin.buildings, [&](const MapBuilding& b) { return b.id != wanted->building; });
  for (MapConnection& connection : origin.connections)
    std::erase_if(connection.landings, [&](const Landing& landing) { return landing.storey != storey; });
  std::erase_if(origin.connections, [](const MapConnection& connection) { return connection.landings.empty(); });
  return SemanticMap::make(map.name(), std::move(objects), std::move(features), {}, std::move(origin));
}

StackedMap with_connections(const StackedMap& stacked, const std::string& file) {
  nlohmann::json more;
  try {
    more = read_json(file);
  } catch (const JsonError& error) {
    throw MapError(error.what());
  }
  if (!more.is_object() || !more.contains("@graph") || !more["@graph"].is_array())
    throw MapError(file + ": has no @graph, expected an array of StoreyConnection nodes");
  nlohmann::ordered_json document = stacked.map->to_json_ld();
  for (const nlohmann::json& node : more["@graph"]) document["@graph"].push_back(nlohmann::ordered_json(node));
  StackedMap connected{SemanticMap::parse(document.dump(), file), stacked.report};
  const std::vector<MapConnection>& known = stacked.map->origin().connections;
  for (const MapConnection& connection : connected.map->origin().connections) {
    if (with_id(known, connection.id) != nullptr) continue;
    check_landings(*connected.map, connection, file);
    connected.report.push_back(sentence_of(connection));
  }
  return connected;
}

}  // namespace opal
