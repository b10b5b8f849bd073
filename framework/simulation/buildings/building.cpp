#include "simulation/buildings/building.hpp"

#include "common/phrases.hpp"
#include "simulation/buildings/kinds.hpp"
#include "simulation/buildings/plan_map.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <functional>

namespace opal::simulation {
namespace {

constexpr double kLeast_m2 = 100, kMost_m2 = 100'000;

using Planner = std::function<PlannedBuilding(Variation&, double)>;
struct Architect {
  BuildingKind kind;
  Planner plan;
};

const std::vector<Architect>& architects() {
  static const std::vector<Architect> all{
      {{"atlas", "20 x 41 m, rooms around open space, 154 concave corners", 0},
       [](Variation&, double) { return plan_atlas(); }},
      {{"gemini", "70 x 17 m, open space and hallway, two rows of round columns", 0},
       [](Variation&, double) { return plan_gemini(); }},
      {{"office", "rooms on both sides of corridors", 1000}, plan_office},
      {{"hall", "open hall with columns, niches and side rooms", 1200}, plan_hall},
      {{"warehouse", "racks and dock doors", 2000}, plan_warehouse},
      {{"corridor", "corridors, crossings and niches", 1500}, plan_corridor}};
  return all;
}

std::string text_of(double number) { return fmt::format("{:g}", number); }

const Architect& architect_of(const std::string& kind) {
  for (const Architect& architect : architects())
    if (architect.kind.name == kind) return architect;
  throw ConfigError("kind of building \"" + kind + "\" is unknown, expected one of " +
                    listed_by(architects(), [](const Architect& architect) { return architect.kind.name; }));
}

double size_of(const BuildingRequest& request, const BuildingKind& kind) {
  if (request.size_m2 == 0) return kind.usual_size_m2;
  if (!(request.size_m2 >= kLeast_m2 && request.size_m2 <= kMost_m2))
    throw ConfigError("size of a building is " + text_of(request.size_m2) + " m^2, expected " + text_of(kLeast_m2) +
                      " to " + text_of(kMost_m2));
  return request.size_m2;
}

std::string name_of(const BuildingRequest& request, const BuildingKind& kind, double size_m2) {
  if (kind.usual_size_m2 == 0) return kind.name;
  return kind.name + " " + std::to_string(request.seed) + ", " + text_of(size_m2) + " m^2, symmetry " +
         text_of(request.symmetry);
}

}  // namespace

const std::vector<BuildingKind>& building_kinds() {
  static const std::vector<BuildingKind> kinds = [] {
    std::vector<BuildingKind> all;
    for (const Architect& architect : architects()) all.push_back(architect.kind);
    return all;
  }();
  return kinds;
}

Building generate_building(const BuildingRequest& request) {
  const Architect& architect = architect_of(request.kind);
  const double size_m2 = size_of(request, architect.kind);
  if (!(request.symmetry >= 0 && request.symmetry <= 1))
    throw ConfigError("symmetry of a building is " + text_of(request.symmetry) + ", expected 0 to 1");
  Variation vary(request.seed, request.symmetry);
  const PlannedBuilding planned = architect.plan(vary, size_m2);
  return {map_of(name_of(request, architect.kind, size_m2), planned.plan), planned.module / 100.0};
}

}  // namespace opal::simulation
