#include "level_choice.hpp"

#include "body_cut.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

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
  return std::ranges::any_of(elements, [&](const Element* element) { return meets(*element, height_m); });
}

std::string names_of(const Building& building) {
  std::string names;
  for (const Level& level : building.levels) names += (names.empty() ? "'" : ", '") + level.name + "'";
  return names;
}

LevelChoice named_level(const Building& building, const ImportOptions& options, const std::string& file) {
  const Level* found = nullptr;
  for (const Level& level : building.levels) {
    if (level.name != options.storey && level.id != options.storey) continue;
    if (found) throw MapError(file + ": two storeys are called '" + options.storey + "', expected z_m (--z) instead");
    found = &level;
  }
  if (!found)
    throw MapError(
        file + ": has no storey '" + options.storey + "', expected " +
        (building.levels.empty() ? "a height (--z): the model has no storeys" : "one of " + names_of(building)));
  const double height_m = found->elevation_m + options.sensor_height_m;
  return {
      height_m, found->name,
      fmt::format("cut at {:.3f} m, {:.2f} m above the storey '{}'", height_m, options.sensor_height_m, found->name)};
}

LevelChoice given_height(const Building& building, double height_m) {
  LevelChoice choice{height_m, "", fmt::format("cut at {:.3f} m, as asked for", height_m)};
  for (const Level& level : building.levels)
    if (level.elevation_m <= height_m) choice.storey = level.name;
  return choice;
}

/// "; without a body: 4 IfcWall"; empty: all have one.
std::string bodiless_things(const Building& building) {
  std::map<std::string, int> counts;
  for (const Element& element : building.elements)
    if (element.bodies.empty()) ++counts[element.source_class()];
  std::string text;
  for (const auto& [name, count] : counts) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
  return text.empty() ? "" : "; without a body: " + text;
}

/// "; cannot be read: 6 things, the first is IfcWall 3k...: has no point"; empty: all can.
std::string unread_things(const Building& building) {
  const auto is_unread = [](const Element& element) { return element.bodies.empty() && !element.troubles.empty(); };
  const auto first = std::ranges::find_if(building.elements, is_unread);
  if (first == building.elements.end()) return bodiless_things(building);
  return fmt::format("; cannot be read: {} things, the first is {} {}: {}",
                     std::count_if(first, building.elements.end(), is_unread), first->source_class(), first->id,
                     first->troubles.front());
}

/// What classes leave out above the lowest storey that has any such thing.
std::string left_out_above(const Building& building, const Classes& classes, double sensor_height_m) {
  for (const Level& level : building.levels)
    if (std::string text = left_out_at(building, classes, level.elevation_m + sensor_height_m); !text.empty())
      return text;
  return "";
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
          fmt::format(
              "cut at {:.3f} m, {:.2f} m above '{}', the lowest storey with {} there (--storey or --z choose another)",
              height_m, options.sensor_height_m, level.name, what)};
    }
  throw MapError(file + ": no storey has anything solid " + fmt::format("{:.2f}", options.sensor_height_m) +
                 " m above it" + left_out_above(building, classes, options.sensor_height_m) + unread_things(building) +
                 ", expected a storey (--storey) of " + names_of(building) + ", or a height (--z)");
}

/// Height of the lowest point of things; infinite if none has any.
double lowest_of(const std::vector<const Element*>& elements) {
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const Element* element : elements)
    if (const double low_m = span_of(element->bodies).low_m; std::isfinite(low_m)) lowest_m = std::min(lowest_m, low_m);
  return lowest_m;
}

/// Of a model without storeys: above the lowest wall, or the lowest solid thing if there are no walls.
LevelChoice lowest_wall(const Building& building, const Classes& classes, const ImportOptions& options,
                        const std::string& file) {
  const char* what = "wall";
  double lowest_m = lowest_of(walls_of(building, classes));
  if (!std::isfinite(lowest_m)) {
    what = "solid thing";
    lowest_m = lowest_of(solids_of(building, classes));
  }
  if (!std::isfinite(lowest_m))
    throw MapError(file + ": has no storeys and no walls" + left_out_at(building, classes, {}) +
                   unread_things(building) + ", expected a height (--z)");
  const double height_m = lowest_m + options.sensor_height_m;
  return {height_m, "",
          fmt::format(
              "cut at {:.3f} m, {:.2f} m above the lowest {}: the model has no storeys (--z chooses another height)",
              height_m, options.sensor_height_m, what)};
}

}  // namespace

LevelChoice choose_level(const Building& building, const Classes& classes, const ImportOptions& options,
                         const std::string& file) {
  if (options.z_m && !options.storey.empty())
    throw MapError(file + ": options storey and z_m are both given, expected one of them");
  if (options.z_m) return given_height(building, *options.z_m);
  if (!options.storey.empty()) return named_level(building, options, file);
  if (building.levels.empty()) return lowest_wall(building, classes, options, file);
  return lowest_level(building, classes, options, file);
}

std::string left_out_at(const Building& building, const Classes& classes, std::optional<double> height_m) {
  std::map<std::string, int> counts;
  for (const Element& element : building.elements)
    if (classes.of(element).kind == Treatment::Kind::left_out &&
        (height_m ? meets(element, *height_m) : !element.bodies.empty()))
      ++counts[element.source_class()];
  if (counts.empty()) return "";
  const auto most = std::ranges::max_element(counts, [](const auto& a, const auto& b) { return a.second < b.second; });
  std::string text;
  for (const auto& [name, count] : counts) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + name;
  return "; there: " + text + ", left out (--set classes." + most->first + "=opal:Wall puts " +
         (counts.size() == 1 ? "them" : "these") + " in)";
}

std::map<std::string, int> counts_at(const Building& building, double height_m) {
  std::map<std::string, int> counts;
  for (const Element& element : building.elements)
    if (meets(element, height_m)) ++counts[element.source_class()];
  return counts;
}

}  // namespace opal::ifc_importer
