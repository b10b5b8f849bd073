#include "benchmark/experiments/integrity/drawn_drive.hpp"

#include <opal/common/error.hpp>

namespace opal::experiments {
namespace {

constexpr const char* kKidnappedName = "kidnapped";
constexpr double kEvent_s = 10;

template <class Named>
Named by_name(const auto& all, const std::string& name, const std::string& pointer) {
  std::string names;
  for (const Named one : all) {
    if (name_of(one) == name) return one;
    names += std::string(names.empty() ? "\"" : ", \"") + name_of(one) + "\"";
  }
  throw ConfigError(pointer + ": \"" + name + "\", expected one of " + names);
}

void set_event(DrawnDrive& drive, const std::string& event) {
  drive.is_kidnapped = event == kKidnappedName;
  if (!drive.is_kidnapped && event != name_of(simulation::Fault::none))
    drive.fault = by_name<simulation::Fault>(simulation::kFaults, event, "/event");
}

/// A number in [low, high].
template <class Number>
Number number_at(const nlohmann::json& document, const char* key, Number low, Number high) {
  const Number value = document.at(key).get<Number>();
  if (value >= low && value <= high) return value;
  throw ConfigError(std::string("/") + key + ": " + document.at(key).dump() + ", expected " +
                    nlohmann::json(low).dump() + " to " + nlohmann::json(high).dump());
}

void read_world(const nlohmann::json& document, DrawnDrive& drive) {
  drive.clutter = number_at(document, "clutter", 0.0, 100.0);
  drive.along_walls = number_at(document, "along_walls", 0.0, simulation::kMostAlongWalls);
  drive.people = number_at(document, "people", 0, 1000);
  drive.doors_open_share = number_at(document, "doors_open_share", 0.0, 1.0);
  drive.duration_s = number_at(document, "duration_s", 1.0, 1e5);
  set_event(drive, document.at("event").get<std::string>());
}

void read_map(const nlohmann::json& document, DrawnDrive& drive) {
  const nlohmann::json& building = document.at("building");
  drive.building_id = building.at("id").get<std::string>();
  drive.building = {building.at("kind").get<std::string>(), building.at("seed").get<std::uint64_t>(),
                    building.at("size_m2").get<double>(), building.at("symmetry").get<double>()};
  drive.storeys = number_at(document, "storeys", 1, 100);
  drive.storey = number_at(document, "storey", 0, drive.storeys - 1);
  drive.map_state = by_name<MapState>(kMapStates, document.at("map").get<std::string>(), "/map");
  drive.damage = number_at(document, "damage", 0.0, 1.0);
  drive.has_two_lasers = number_at(document, "lasers", 1, 2) == 2;
}

}  // namespace

const char* name_of(MapState state) {
  switch (state) {
    case MapState::sound: return "sound";
    case MapState::plan: return "plan";
    case MapState::damaged: return "damaged";
    case MapState::redrawn: return "redrawn";
    case MapState::learned: break;
  }
  return "learned";
}

std::string event_of(const DrawnDrive& drive) { return drive.is_kidnapped ? kKidnappedName : name_of(drive.fault); }

simulation::FaultWindow event_window(const DrawnDrive& drive) {
  const double from_s = drive.duration_s / 2;
  return {from_s, drive.is_kidnapped ? from_s : from_s + kEvent_s};
}

nlohmann::ordered_json to_json(const DrawnDrive& drive) {
  const simulation::BuildingRequest& building = drive.building;
  return {{"drive", drive.number},
          {"building",
           {{"id", drive.building_id},
            {"kind", building.kind},
            {"seed", building.seed},
            {"size_m2", building.size_m2},
            {"symmetry", building.symmetry}}},
          {"storeys", drive.storeys},
          {"storey", drive.storey},
          {"map", name_of(drive.map_state)},
          {"damage", drive.damage},
          {"lasers", drive.has_two_lasers ? 2 : 1},
          {"clutter", drive.clutter},
          {"along_walls", drive.along_walls},
          {"people", drive.people},
          {"doors_open_share", drive.doors_open_share},
          {"event", event_of(drive)},
          {"duration_s", drive.duration_s},
          {"seed", drive.seed}};
}

DrawnDrive drawn_drive_from(const nlohmann::json& document, const std::string& file) {
  try {
    DrawnDrive drive;
    drive.number = document.at("drive").get<std::size_t>();
    drive.seed = document.at("seed").get<std::uint64_t>();
    read_map(document, drive);
    read_world(document, drive);
    return drive;
  } catch (const nlohmann::json::exception& error) {
    throw ConfigError(file + ": is no drive of a campaign: " + error.what());
  } catch (const ConfigError& error) {
    throw ConfigError(file + ": " + error.what());
  }
}

}  // namespace opal::experiments
