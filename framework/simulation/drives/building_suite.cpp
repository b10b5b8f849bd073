#include "simulation/drives/building_suite.hpp"

#include "common/phrases.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace opal::simulation {
namespace {

/// Kinds of which seeds make many.
std::vector<BuildingKind> kinds_of(const SuiteRequest& request) {
  std::vector<BuildingKind> kinds;
  std::vector<std::string> known;
  for (const BuildingKind& kind : building_kinds()) {
    if (kind.usual_size_m2 == 0) continue;
    known.push_back(kind.name);
    const bool wanted = std::find(request.kinds.begin(), request.kinds.end(), kind.name) != request.kinds.end();
    if (wanted || request.kinds.empty()) kinds.push_back(kind);
  }
  for (const std::string& name : request.kinds)
    if (std::none_of(kinds.begin(), kinds.end(), [&](const BuildingKind& kind) { return kind.name == name; }))
      throw ConfigError("suite of buildings: kind \"" + name + "\", expected some of " + listed(known));
  return kinds;
}

void check(const SuiteRequest& request) {
  for (double difficulty : request.difficulties)
    if (!(difficulty >= 0 && difficulty <= 1))
      throw ConfigError("suite of buildings: difficulty " + std::to_string(difficulty) + ", expected 0 to 1");
  std::set<long> percents;  // buildings are named by them
  for (const double difficulty : request.difficulties)
    if (!percents.insert(std::lround(100 * difficulty)).second)
      throw ConfigError(
          fmt::format("suite of buildings: difficulty {} twice, expected others that differ by 0.01", difficulty));
  if (request.difficulties.empty())
    throw ConfigError("suite of buildings: no difficulty, expected at least one in 0 to 1");
}

SuiteBuilding building_of(const SuiteRequest& request, const BuildingKind& kind, double difficulty, int seed) {
  SuiteBuilding building;
  building.id = kind.name + "-" + std::to_string(std::lround(100 * difficulty)) + "-" + std::to_string(seed);
  building.difficulty = difficulty;
  building.request = {kind.name, static_cast<std::uint64_t>(seed),
                      std::round(kind.usual_size_m2 * request.size_factor.value_or(std::pow(4, difficulty - 0.5))),
                      request.symmetry.value_or(difficulty)};
  building.clutter = request.clutter.value_or(2 * difficulty);
  return building;
}

}  // namespace

std::vector<SuiteBuilding> building_suite(const SuiteRequest& request) {
  check(request);
  const std::vector<BuildingKind> kinds = kinds_of(request);
  std::vector<SuiteBuilding> suite;
  for (int seed = 1;; ++seed)
    for (double difficulty : request.difficulties)
      for (const BuildingKind& kind : kinds) {
        if (static_cast<int>(suite.size()) >= request.buildings) return suite;
        suite.push_back(building_of(request, kind, difficulty, seed));
      }
}

std::vector<Challenge> challenges_in(const SuiteBuilding& building) {
  std::vector<Challenge> all = thesis3_challenges();
  for (Challenge& challenge : all) challenge.clutter.level *= building.clutter;
  return all;
}

}  // namespace opal::simulation
