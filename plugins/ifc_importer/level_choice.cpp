#include "level_choice.hpp"

#include "body_cut.hpp"

#include <opal/common/error.hpp>
#include <opal/common/sentence.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace opal::ifc_importer {
namespace {

bool meets(const Element& element, double height_m) {
  const Span span = span_of(element.bodies);
  return span.low_m <= height_m && height_m < span.high_m;
}

/// Walls, by their own bodies or by their parts.
std::vector<const Element*> walls_of(const Building& building, const Classes& classes) {
  std::set<std::string> walls;
  for (const Element& element : building.elements)
    if (classes.of(element).type == "opal:Wall") walls.insert(element.id);
  std::vector<const Element*> bodies;
  for (const Element& element : building.elements)
    if (walls.count(element.id) || walls.count(element.whole)) bodies.push_back(&element);
  return bodies;
}

/// Of what rooms have.
std::vector<const Element*> doors_of(const Building& building, const Classes& classes) {
  std::vector<const Element*> doors;
  for (const Element& element : building.elements)
    if (classes.of(element).type == "opal:Door") doors.push_back(&element);
  return doors;
}

std::vector<const Element*> solids_of(const Building& building, const Classes& classes) {
  std::vector<const Element*> solids;
  for (const Element& element : building.elements)
    if (classes.of(element).kind == Treatment::Kind::solid) solids.push_back(&element);
  return solids;
}

bool any_meets(const std::vector<const Element*>& elements, double height_m) {
  return std::any_of(elements.begin(), elements.end(),
                     [&](const Element* element) { return meets(*element, height_m); });
}

std::string names_of(const Building& building) {
  std::string names;
  for (const Level& level : building.levels) names += (names.empty() ? "'" : ", '") + level.name + "'";
  return names.empty() ? "none: the model has no storeys, give z_m (--z)" : names;
}

LevelChoice named_level(const Building& building, const ImportOptions& options, const std::string& file) {
  const Level* found = nullptr;
  for (const Level& level : building.levels) {
    if (level.name != options.storey && level.id != options.storey) continue;
    if (found) throw MapError(file + ": two storeys are called '" + options.storey + "', expected z_m (--z) instead");
    found = &level;
  }
  if (!found) throw MapError(file + ": has no storey '" + options.storey + "', expected one of " + names_of(building));
  const double height_m = found->elevation_m + options.sensor_height_m;
  return {
      height_m, found->name,
      sentence("cut at %.3f m, %.2f m above the storey '%s'", height_m, options.sensor_height_m, found->name.c_str())};
}

LevelChoice given_height(const Building& building, double height_m) {
  LevelChoice choice{height_m, "", sentence("cut at %.3f m, as asked for", height_m)};
  for (const Level& level : building.levels)
    if (level.elevation_m <= height_m) choice.storey = level.name;
  return choice;
}

/// A foundation has walls and no doors. A model without doors, or of columns alone, has a level, too.
LevelChoice lowest_level(const Building& building, const Classes& classes, const ImportOptions& options,
                         const std::string& file) {
  const auto walls = walls_of(building, classes), doors = doors_of(building, classes),
             solids = solids_of(building, classes);
  using Things = std::vector<const Element*>;
  struct Wanted {
    const Things &one, &other;
    const char* what;
  };
  for (const auto& [one, other, what] :
       {Wanted{walls, doors, "walls and doors"}, Wanted{walls, walls, "walls"}, Wanted{solids, solids, "solid things"}})
    for (const Level& level : building.levels) {
      const double height_m = level.elevation_m + options.sensor_height_m;
      if (!any_meets(one, height_m) || !any_meets(other, height_m)) continue;
      return {
          height_m, level.name,
          sentence("cut at %.3f m, %.2f m above '%s', the lowest storey with %s there (--storey or --z choose another)",
                   height_m, options.sensor_height_m, level.name.c_str(), what)};
    }
  throw MapError(file + ": no storey has anything solid " + sentence("%.2f", options.sensor_height_m) +
                 " m above it, expected a storey (--storey) of " + names_of(building) + ", or a height (--z)");
}

}  // namespace

LevelChoice choose_level(const Building& building, const Classes& classes, const ImportOptions& options,
                         const std::string& file) {
  if (options.z_m && !options.storey.empty())
    throw MapError(file + ": options storey and z_m are both given, expected one of them");
  if (options.z_m) return given_height(building, *options.z_m);
  if (!options.storey.empty()) return named_level(building, options, file);
  return lowest_level(building, classes, options, file);
}

std::map<std::string, int> counts_at(const Building& building, double height_m) {
  std::map<std::string, int> counts;
  for (const Element& element : building.elements)
    if (meets(element, height_m)) ++counts[element.source_class()];
  return counts;
}

}  // namespace opal::ifc_importer
