#include "plan_elements.hpp"

#include <opal/common/error.hpp>
#include <opal/import_kit/first_ids.hpp>
#include <opal/import_kit/mean_thickness.hpp>
#include <opal/import_kit/wide_walls.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace opal::geojson_importer {
namespace {

constexpr double kFarthest_m = 1e6;
constexpr std::size_t kMostEdges = 200'000;
// A pane is thicker.
constexpr double kThinnestWall_m = 0.02;

const std::map<std::string, Area::Kind>& kinds_of_areas() {
  static const std::map<std::string, Area::Kind> kKinds{
      {kRoom, Area::Kind::room}, {kCorridor, Area::Kind::corridor}, {kArea, Area::Kind::open}};
  return kKinds;
}

/// Polygons, and lines that are closed: some exports have areas so.
std::vector<std::vector<Ring>> polygons_of(const Shapes& shapes) {
  std::vector<std::vector<Ring>> polygons = shapes.polygons;
  for (const auto& line : shapes.lines)
    if (line.size() > 3 && line.front() == line.back()) polygons.push_back({Ring(line.begin(), line.end() - 1)});
  return polygons;
}

bool is_seen_wall(const PlanElement& element) { return element.type == "opal:Wall" && !element.sensor.empty(); }

bool is_thin(const PlanLine& line) { return line.sides == PlanSides::both && !line.closed; }

// Numbers of the outlines of pieces: polygons of the same element have lower ones.
constexpr int kFirstPiece = 1'000'000;

// Of a door that is an area: it cuts walls, and is an object already.
constexpr const char* kAreaOfDoor = "";

}  // namespace

void PlanElements::add(const Feature& feature, const FeatureClasses& classes) {
  const std::string& type = feature.type;
  if (type.empty()) return leave_out(feature, classes, "no class for it", ImportStatus::left_out);
  if (type == ClassRules::kLeaveOut) return leave_out(feature, classes, "a rule says so", ImportStatus::left_out);
  if (!feature.damage.empty()) throw MapError(feature.damage);
  expect_near(feature);
  if (const std::string trouble = use(feature, type); !trouble.empty())
    return leave_out(feature, classes, trouble, ImportStatus::unreadable);
  names.insert(names.end(), classes.names.begin(), classes.names.end());
  tally.count_used(classes.shown, type, feature.geometry);
  things.push_back({feature.id, classes.shown, feature.geometry});
}

void PlanElements::leave_out(const Feature& feature, const FeatureClasses& classes, const std::string& why,
                             ImportStatus status) {
  const std::string geometry = feature.geometry.empty() ? "null" : feature.geometry;
  names.insert(names.end(), classes.names.begin(), classes.names.end());
  tally.count_left_out(classes.shown, why, geometry, feature.id);
  things.push_back({feature.id, classes.shown, geometry, status, why});
}

void PlanElements::expect_near(const Feature& feature) const {
  visit_positions(feature.shapes, [&](const Point& p) {
    if (!(p.cwiseAbs().maxCoeff() <= kFarthest_m))
      throw MapError(fmt::format(
          "{}: '{}': a position at {} {}, expected all within 1e6 m of the origin (options origin_x_m, origin_y_m)",
          source_, feature.id, p.x(), p.y()));
  });
}

std::string PlanElements::use(const Feature& feature, const std::string& type) {
  const Shapes& shapes = feature.shapes;
  if (shapes.points.empty() && shapes.lines.empty() && shapes.polygons.empty()) return "it has no geometry";
  if (const auto kind = kinds_of_areas().find(type); kind != kinds_of_areas().end())
    return use_area(feature, kind->second);
  if (type == kOpening || (type == "opal:Door" && !feature.properties.contains(options_.radius_property)))
    if (shapes.polygons.empty()) return use_opening(feature, type);
  if (type == kOpening) return "an opening is a point or a line";
  PlanElement element{feature.id, type, plan_.sensor_for(type)};
  if (!shapes.points.empty()) {
    const std::optional<double> radius_m = radius_of(feature);
    if (!radius_m) return "a point without a positive " + options_.radius_property;
    for (const Point& p : shapes.points) element.circles.push_back({p, *radius_m});
  }
  for (const auto& line : shapes.lines) element.lines.push_back({line, false, PlanSides::both});
  if (type == "opal:Wall" && !shapes.lines.empty()) note_width(feature);
  int solid = 0;
  for (const auto& polygon : shapes.polygons) add_polygon(polygon, ++solid, element);
  if (type == "opal:Door")
    for (const auto& polygon : shapes.polygons) {
      openings_.push_back({feature.id, line_through(polygon.front()), 0});
      type_of_opening_.push_back(kAreaOfDoor);
    }
  elements.push_back(std::move(element));
  return "";
}

void PlanElements::note_width(const Feature& feature) {
  const std::optional<double> width_m = wall_width_m_of(feature);
  if (!width_m) return;
  if (*width_m >= kThinnestWall_m && *width_m <= plan_.plan.max_wall_thickness_m)
    width_m_[elements.size()] = *width_m;
  else
    odd_widths_.push_back(feature.id);
}

std::string PlanElements::use_area(const Feature& feature, Area::Kind kind) {
  Area area{feature.id, kind, polygons_of(feature.shapes)};
  if (area.polygons.empty()) return "no polygon, of which an area would be made";
  for (const auto& polygon : area.polygons)
    for (const Ring& ring : polygon) area_edges_ += ring.size();
  if (area_edges_ > kMostEdges)
    throw MapError(fmt::format("{}: more than {} edges of areas, expected a plan of one storey", source_, kMostEdges));
  areas_.push_back(std::move(area));
  element_of_area_.push_back(elements.size());
  elements.push_back({feature.id, "opal:Wall", plan_.sensor_for("opal:Wall")});
  return "";
}

std::string PlanElements::use_opening(const Feature& feature, const std::string& type) {
  const double width_m = width_m_of(feature).value_or(options_.door_width_m);
  const auto add_line = [&](const Segment& line) {
    openings_.push_back({feature.id, line, width_m});
    type_of_opening_.push_back(type);
  };
  for (const Point& p : feature.shapes.points) add_line({p, p});
  for (const auto& line : feature.shapes.lines)
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      if (line[k] != line[k + 1]) add_line({line[k], line[k + 1]});
  return "";
}

std::optional<double> PlanElements::radius_of(const Feature& feature) const {
  const std::string& name = options_.radius_property;
  if (!feature.properties.contains(name) || !feature.properties.at(name).is_number()) return std::nullopt;
  const double radius_m = feature.properties.at(name);
  return radius_m > 0 ? std::optional<double>(radius_m) : std::nullopt;
}

void PlanElements::add_polygon(const std::vector<Ring>& polygon, int solid, PlanElement& element) {
  const auto circle =
      polygon.size() == 1 ? circle_drawn_by(polygon.front(), options_.circle_tolerance_m) : std::nullopt;
  if (circle && circle->radius_m <= options_.max_column_radius_m) {
    element.circles.push_back(*circle);
    ++refitted;
    return;
  }
  if (element.type == "opal:Wall" && mean_thickness_m(polygon) > plan_.plan.max_wall_thickness_m) {
    for (Ring ring : polygon) {
      ring.push_back(ring.front());
      element.lines.push_back({std::move(ring), false, PlanSides::both});
    }
    if (ringed_.empty() || ringed_.back() != element.id) ringed_.push_back(element.id);
    return;
  }
  for (const Ring& ring : polygon) element.lines.push_back({ring, true, PlanSides::solid, solid});
}

/// Straight pieces of the walls that were drawn as lines; without doors, lines stay whole.
std::vector<AreaWall> PlanElements::thin_walls() const {
  std::vector<AreaWall> walls;
  for (std::size_t k = 0; !openings_.empty() && k < elements.size(); ++k)
    if (is_seen_wall(elements[k]))
      for (const PlanLine& line : elements[k].lines)
        for (std::size_t p = 0; is_thin(line) && p + 1 < line.points.size(); ++p)
          if (line.points[p] != line.points[p + 1])
            walls.push_back({static_cast<int>(k), {line.points[p], line.points[p + 1]}});
  return walls;
}

void PlanElements::put_back(const std::vector<AreaWall>& walls) {
  for (const AreaWall& wall : walls) {
    const auto element = static_cast<std::size_t>(wall.element);
    const bool is_area = std::binary_search(element_of_area_.begin(), element_of_area_.end(), element);
    elements[element].lines.push_back(
        {{wall.line.begin, wall.line.end}, false, is_area ? PlanSides::to_find : PlanSides::both});
  }
}

void PlanElements::widen() {
  std::vector<WidePiece> pieces;
  std::vector<std::size_t> element_of_piece;
  for (const auto& [element, width_m] : width_m_) {
    for (const PlanLine& line : elements[element].lines)
      for (std::size_t p = 0; is_thin(line) && p + 1 < line.points.size(); ++p) {
        if (line.points[p] == line.points[p + 1]) continue;
        pieces.push_back({{line.points[p], line.points[p + 1]}, width_m});
        element_of_piece.push_back(element);
      }
    std::erase_if(elements[element].lines, is_thin);
  }
  int solid = 0;
  const auto outlines = widened(pieces);
  for (std::size_t k = 0; k < outlines.size(); ++k)
    elements[element_of_piece[k]].lines.push_back({outlines[k], true, PlanSides::solid, kFirstPiece + ++solid});
}

void PlanElements::finish() {
  std::vector<AreaWall> walls = thin_walls();
  for (const AreaWall& wall : walls) std::erase_if(elements[static_cast<std::size_t>(wall.element)].lines, is_thin);
  for (AreaWall wall : walls_around(areas_)) {
    wall.element = static_cast<int>(element_of_area_[static_cast<std::size_t>(wall.element)]);
    walls.push_back(wall);
  }
  const auto places = cut_openings(openings_, plan_.plan.max_wall_thickness_m, walls);
  put_back(walls);
  widen();
  find_closed(places);
  put_in_doors(places);
  std::erase_if(elements, [](const PlanElement& element) { return element.lines.empty() && element.circles.empty(); });
}

void PlanElements::find_closed(const std::vector<std::optional<Segment>>& places) {
  const MassiveWalls massive(elements);
  for (std::size_t k = 0; k < openings_.size(); ++k) {
    const Segment line = places[k].value_or(openings_[k].line);
    const std::string wall = massive.wall_at((line.begin + line.end) / 2);
    if (wall.empty()) continue;
    closed_.emplace(openings_[k].id, wall);
    in_massive_ += !places[k] && type_of_opening_[k] != kAreaOfDoor;
  }
}

void PlanElements::put_in_doors(const std::vector<std::optional<Segment>>& places) {
  std::map<std::string, std::size_t> doors;
  for (std::size_t k = 0; k < openings_.size(); ++k) {
    const Opening& opening = openings_[k];
    cut_ += places[k].has_value();
    wall_less_ += !places[k] && type_of_opening_[k] != kAreaOfDoor;
    report_opening(opening, places[k].has_value());
    if (type_of_opening_[k] == kOpening || type_of_opening_[k] == kAreaOfDoor || (!places[k] && opening.is_point()))
      continue;
    const auto [door, is_new] = doors.try_emplace(opening.id, elements.size());
    if (is_new) elements.push_back({opening.id, "opal:Door", plan_.sensor_for("opal:Door")});
    const Segment line = places[k].value_or(opening.line);
    elements[door->second].lines.push_back({{line.begin, line.end}, false, PlanSides::both});
  }
}

void PlanElements::report_opening(const Opening& opening, bool is_in_wall) {
  if (is_in_wall || !opening.is_point()) return;
  const auto thing = std::find_if(things.begin(), things.end(),
                                  [&](const ImportedElement& element) { return element.id == opening.id; });
  thing->status = ImportStatus::unreadable;
  const auto closed = closed_.find(opening.id);
  thing->reason = closed == closed_.end() ? fmt::format("no wall is within {} m of it", plan_.plan.max_wall_thickness_m)
                                          : "it lies in the massive wall " + closed->second + ", which is not cut";
}

std::vector<std::string> PlanElements::sentences() const {
  std::vector<std::string> sentences;
  if (refitted > 0) sentences.push_back(fmt::format("circles that were drawn as polygons: {}", refitted));
  if (!ringed_.empty())
    sentences.push_back(
        fmt::format("walls that enclose more than a wall (mean thickness over {} m), taken as thin walls "
                    "along their outlines: {} ({})",
                    plan_.plan.max_wall_thickness_m, ringed_.size(), first_of(ringed_)));
  if (!width_m_.empty())
    sentences.push_back(fmt::format("walls drawn as lines that are as thick as their width says: {}", width_m_.size()));
  if (!odd_widths_.empty())
    sentences.push_back(
        fmt::format("doubtful: walls drawn as lines whose width is no thickness of a wall, taken as "
                    "thin walls: {} ({})",
                    odd_widths_.size(), first_of(odd_widths_)));
  if (!areas_.empty()) sentences.push_back(fmt::format("walls were put around {} areas", areas_.size()));
  if (cut_ + wall_less_ > 0)
    sentences.push_back(fmt::format("doors and openings: {} cut into walls, {} where no wall is{}", cut_,
                                    wall_less_ - in_massive_,
                                    in_massive_ > 0 ? fmt::format(", {} in massive walls", in_massive_) : ""));
  std::vector<std::string> closed;
  for (const auto& [door, wall] : closed_) closed.push_back(door + " in " + wall);
  if (!closed.empty())
    sentences.push_back(fmt::format("doubtful: doors that are closed by massive walls, which are not cut: {} ({})",
                                    closed.size(), first_of(closed)));
  return sentences;
}

}  // namespace opal::geojson_importer
