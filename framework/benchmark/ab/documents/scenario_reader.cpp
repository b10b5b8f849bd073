#include "benchmark/ab/documents/scenario_reader.hpp"

#include <opal/common/error.hpp>

#include "simulation/drives/challenges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace opal::ab {
namespace {

namespace fs = std::filesystem;

constexpr int kMostSeeds = 1'000'000;

/// `seeds`: how many, from 1 on.
std::vector<std::uint64_t> read_seeds(ConfigObject& object, int fallback) {
  std::vector<std::uint64_t> seeds;
  for (int seed = 1, last = object.integer("seeds", fallback, {1, kMostSeeds}); seed <= last; ++seed)
    seeds.push_back(static_cast<std::uint64_t>(seed));
  return seeds;
}

std::string read_damage(ConfigObject& object) {
  const std::string words = object.text("damage", "");
  if (words.empty()) return words;
  try {
    read_map_damage(words);
  } catch (const ConfigError& error) {
    throw ConfigError(object.where("damage") + ": " + error.what());
  }
  return words;
}

void expect_name(const std::string& name, const ConfigObject& object, const std::string& key) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-' || c == '.'; };
  if (name.empty() || !std::ranges::all_of(name, allowed)) object.refuse(key, "a name of letters, digits, _, - and .");
}

Scenario read_site(ConfigObject object, const std::string& file, int seeds) {
  Scenario scenario;
  const std::string prefix = beside(file, object.required_text("prefix"));
  if (const std::string queries = prefix + ".queries.json"; !fs::exists(queries))
    object.refuse("prefix", "the prefix of a recorded place: " + queries + " does not exist");
  scenario.source = RecordedPlace{prefix, object.texts("queries")};
  scenario.name = object.text("name", fs::path(prefix).filename().string());
  expect_name(scenario.name, object, "name");
  object.text("comment", "");
  scenario.damage = read_damage(object);
  if (scenario.damage.empty() && !object.any("seeds").is_null())
    object.refuse("seeds", "no seeds: without damage, a recording is the same for every seed");
  scenario.seeds = read_seeds(object, scenario.damage.empty() ? 1 : seeds);
  object.expect_no_more();
  return scenario;
}

simulation::BuildingRequest read_building(ConfigObject object) {
  simulation::BuildingRequest request;
  request.kind = object.required_text("kind");
  const auto& kinds = simulation::building_kinds();
  const auto kind = std::ranges::find_if(kinds, [&](const auto& k) { return k.name == request.kind; });
  if (kind == kinds.end()) object.refuse("kind", "a kind of building that opal map generate knows");
  request.seed = static_cast<std::uint64_t>(object.integer("seed", 1, {0, 1e9}));
  request.size_m2 = object.number("size_m2", request.size_m2, {0, 100'000});
  request.symmetry = object.number("symmetry", request.symmetry, {0, 1});
  object.expect_no_more();
  return request;
}

/// Who says what stands there, and how it is driven: the challenge, or these keys.
void read_drives(ConfigObject& object, SimulatedDrives& drives) {
  auto& world = drives.world;
  drives.drives.drives = object.integer("drives", 1, {1, 1000});
  drives.drives.distance_m = object.number("distance_m", drives.drives.distance_m, {1, 10'000});
  world.clutter.level = object.number("clutter", world.clutter.level, {0, 100});
  world.clutter.lookalikes = object.number("lookalikes", world.clutter.lookalikes, {0, 100});
  world.clutter.hidden_share = object.number("hidden", world.clutter.hidden_share, {0, 1});
  world.clutter.along_walls = object.number("along_walls", world.clutter.along_walls, {0, simulation::kMostAlongWalls});
  world.people = object.integer("people", world.people, {0, 1000});
  world.doors_open_share = object.number("doors_open", world.doors_open_share, {0, 1});
}

void read_challenge(ConfigObject& object, SimulatedDrives& drives) {
  const auto all = simulation::thesis3_challenges();
  const auto known = [&](const simulation::Challenge& challenge) { return challenge.id == *drives.challenge; };
  if (std::ranges::none_of(all, known)) object.refuse("challenge", "A1, A3, B1 to B10, C11 or C12");
  drives.duration_s = object.number("duration_s", drives.duration_s, {1, 36'000});
}

Scenario read_simulated(ConfigObject& object, const std::string& file, int seeds) {
  Scenario scenario;
  SimulatedDrives drives;
  scenario.name = read_name(object);
  object.text("comment", "");
  if (auto building = object.object("building")) drives.building = read_building(*building);
  if (const std::string map = object.text("map", ""); !map.empty()) drives.map = beside(file, map);
  if (drives.building.has_value() != drives.map.empty()) object.refuse("map", "either a map or a building to make");
  const std::string challenge = object.text("challenge", "");
  if (!challenge.empty()) drives.challenge = challenge;
  drives.challenge ? read_challenge(object, drives) : read_drives(object, drives);
  scenario.damage = read_damage(object);
  scenario.seeds = read_seeds(object, seeds);
  scenario.source = std::move(drives);
  return scenario;
}

/// `buildings`: the same in so many buildings of the kind, each a scenario of its own.
std::vector<Scenario> read_all_simulated(ConfigObject object, const std::string& file, int seeds) {
  const Scenario scenario = read_simulated(object, file, seeds);
  const auto& building = std::get<SimulatedDrives>(scenario.source).building;
  const int buildings = object.integer("buildings", 0, {1, 10'000});
  object.expect_no_more();
  if (buildings == 0) return {scenario};
  if (!building) object.refuse("buildings", "no number of buildings for one map");
  std::vector<Scenario> all(static_cast<std::size_t>(buildings), scenario);
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::get<SimulatedDrives>(all[k].source).building->seed = building->seed + k;
    all[k].name += fmt::format("-{}", building->seed + k);
  }
  return all;
}

}  // namespace

std::string read_name(ConfigObject& object) {
  const std::string name = object.required_text("name");
  expect_name(name, object, "name");
  return name;
}

std::vector<Scenario> read_scenarios(ConfigObject& document, const std::string& file) {
  const int seeds = document.integer("seeds", 1, {1, kMostSeeds});
  std::vector<Scenario> scenarios;
  const auto add = [&](Scenario scenario, const ConfigObject& object) {
    for (const Scenario& other : scenarios)
      if (other.name == scenario.name)
        object.refuse("name", "a name that no other scenario has, found \"" + scenario.name + "\" twice");
    scenarios.push_back(std::move(scenario));
  };
  if (const auto sites = document.list("sites"))
    for (const ConfigObject& object : *sites) add(read_site(object, file, seeds), object);
  if (const auto simulated = document.list("simulated"))
    for (const ConfigObject& object : *simulated)
      for (Scenario& scenario : read_all_simulated(object, file, seeds)) add(std::move(scenario), object);
  if (scenarios.empty()) document.refuse("sites", "at least one recorded place, or one of \"simulated\"");
  return scenarios;
}

}  // namespace opal::ab
