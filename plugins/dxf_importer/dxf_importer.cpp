#include "dxf_importer.hpp"

#include "doubts.hpp"
#include "entity_sorting.hpp"

#include <opal/common/error.hpp>
#include <opal/common/letter_case.hpp>
#include <opal/import_kit/far_origin.hpp>
#include <opal/import_kit/first_ids.hpp>

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <filesystem>

namespace opal::dxf_importer {
namespace {

// A drawing that says mm and is one in inches becomes a building of a metre.
constexpr double kSmallestBuilding_m = 2;
// A drawing of 57 m that says inches is 1.4 m large; one of 130 m is 3.3 m large, and few buildings are.
constexpr double kSmallBuilding_m = 5;

/// Of everything that shall become map.
Eigen::AlignedBox2d bounds_of(const std::vector<PlanElement>& elements) {
  Eigen::AlignedBox2d box;
  for (const PlanElement& element : elements) {
    for (const PlanLine& line : element.lines)
      for (const Point& p : line.points) box.extend(p);
    for (const Circle& circle : element.circles) {
      const Point radius = Point::Constant(circle.radius_m);
      box.extend(circle.center - radius).extend(circle.center + radius);
    }
  }
  return box;
}

/// "plans/office.dxf" is called "office".
std::string name_of(const std::string& path) {
  const std::string name = std::filesystem::path(path).stem().string();
  return name.empty() ? "drawing" : name;
}

/// What is drawn as a door first, then what may be one.
std::vector<DoorStroke> door_strokes(const EntitySorting& sorting) {
  std::vector<DoorStroke> strokes;
  for (const PlanElement& element : sorting.elements)
    for (const PlanLine& line : element.lines) {
      if (element.type == "opal:Wall" || element.type == "opal:Column") continue;
      strokes.push_back({element.id, element.type == "opal:Door", line.points});
    }
  strokes.insert(strokes.end(), sorting.perhaps_doors.begin(), sorting.perhaps_doors.end());
  return strokes;
}

/// "; blocks that stand for other files, to be bound: ARCH" of a drawing that refers to others.
std::string hint_at_references(const DxfDrawing& drawing) {
  std::vector<std::string> names;
  for (const auto& [name, block] : drawing.blocks)
    if (block.is_external) names.push_back(name);
  return names.empty() ? "" : "; blocks that stand for other drawings, which are to be bound first: " + first_of(names);
}

/// @throws MapError if nothing that a sensor perceives comes in: no unit is to blame for that.
void expect_perceivable(const std::string& path, const DxfDrawing& drawing, const EntitySorting& sorting) {
  const bool is_perceivable = std::any_of(sorting.elements.begin(), sorting.elements.end(),
                                          [](const PlanElement& element) { return !element.sensor.empty(); });
  if (is_perceivable) return;
  throw MapError(fmt::format(
      "{}: no layer gives anything {}, expected the option classes to name one of (--set \"classes.LAYER=Wall\"): {}{}",
      path, sorting.elements.empty() ? "for a map" : "that a sensor perceives", sorting.tally.overview(),
      hint_at_references(drawing)));
}

/// @throws MapError if nothing that a sensor perceives is as long as a face: sections of profiles, symbols.
void expect_features(const std::string& path, const EntitySorting& sorting, const SemanticMap& map, double min_face_m) {
  const std::vector<MapFeature>& features = map.features();
  if (std::any_of(features.begin(), features.end(), [](const MapFeature& f) { return !f.sensor.empty(); })) return;
  throw MapError(
      fmt::format("{}: no line of walls and columns is {} m long or longer, expected a plan: the option unit "
                  "says what it is drawn in, and the option classes what of it is a wall: {}",
                  path, min_face_m, sorting.tally.overview()));
}

/// Clips are not applied: what they hide of a block comes in, too.
void add_clips(const DxfDrawing& drawing, std::vector<std::string>& sentences) {
  if (drawing.clips == 0) return;
  sentences.push_back(
      fmt::format("doubtful: clips that show a part of a block (XCLIP), and the block came in whole: {}{}",
                  drawing.clips, drawing.clipped.empty() ? "" : " (" + first_of(drawing.clipped) + ")"));
}

/// What is not in the map and is no entity, and what was made of curves.
std::vector<std::string> about_drawing(const EntitySorting& sorting, const DxfDrawing& drawing) {
  std::vector<std::string> sentences;
  const auto add = [&](int count, const char* words) {
    if (count > 0) sentences.push_back(fmt::format("{}: {}", words, count));
  };
  add(sorting.refitted, "circles that were drawn as closed lines");
  add(sorting.chorded, "curved lines that became short straight ones, at most 5 mm off");
  add(sorting.wide, "walls as thick as their polylines are drawn");
  add(sorting.oddly_wide,
      "doubtful: polylines drawn with a width that is no thickness of a wall, of which the middle was taken");
  if (const auto& blocks = sorting.walls_of_layer_0; !blocks.empty())
    sentences.push_back(fmt::format(
        "doubtful: blocks on layer 0 whose lines became walls with it (--set \"classes.NAME=leave_out\"): {} ({})",
        blocks.size(), first_of(std::vector<std::string>(blocks.begin(), blocks.end()))));
  add(sorting.open_loops, "left out: loops of hatches whose edges do not meet");
  for (const std::string& block : drawing.repeated_blocks)
    sentences.push_back("left out: a second block of the same name: " + block);
  add_clips(drawing, sentences);
  if (drawing.lacks_end) sentences.push_back("doubtful: the file ends without EOF, after its entities");
  add(drawing.lines_after_end, "left out: lines of text after EOF, where the drawing ends");
  return sentences;
}

}  // namespace

DxfImporter::DxfImporter(const nlohmann::json& options)
    : plan_(options, classes_of_layers()), classes_(options.at("classes")) {
  shape_.origin_m = {options.at("origin_x_m").get<double>(), options.at("origin_y_m").get<double>()};
  shape_.circle_tolerance_m = options.at("circle_tolerance_m");
  shape_.max_column_radius_m = options.at("max_column_radius_m");
  const std::string name = options.at("unit");
  unit_ = length_unit_called(name);
  if (!unit_ && !name.empty())
    throw ConfigError("opal:DxfImporter: option unit: \"" + name + "\", expected one of: " + length_unit_names());
}

bool DxfImporter::recognizes(const std::string& path) const {
  std::error_code error;
  const std::string extension = upper_case_letters(std::filesystem::path(path).extension().string());
  return (extension == ".DXF" || extension == ".DWG") && std::filesystem::is_regular_file(path, error);
}

void DxfImporter::expect_classes(const std::string& path, const DxfDrawing& drawing,
                                 const std::vector<PlacedEntity>& entities) const {
  if (unit_ || (drawing.insunits && *drawing.insunits != 0)) return;
  ShapeOptions shape = shape_;
  shape.metres_per_unit = 0.001;  // any will do, and a small one makes few chords
  expect_perceivable(path, drawing, sorted(drawing, entities, shape));
}

EntitySorting DxfImporter::sorted(const DxfDrawing& drawing, const std::vector<PlacedEntity>& entities,
                                  const ShapeOptions& shape) const {
  EntitySorting sorting(plan_, classes_, shape, drawing);
  for (const PlacedEntity& placed : entities) sorting.add(placed);
  sorting.finish();
  return sorting;
}

LengthUnit DxfImporter::unit_of(const std::string& path, const DxfDrawing& drawing) const {
  if (unit_) return *unit_;
  if (!drawing.insunits || *drawing.insunits == 0)
    throw MapError(path + ": does not say in which unit it is drawn ($INSUNITS), expected the option unit: one of " +
                   length_unit_names());
  const std::optional<LengthUnit> unit = unit_of_insunits(*drawing.insunits);
  if (!unit)
    throw MapError(fmt::format(
        "{}: is drawn in the unit $INSUNITS {}, expected 1, 2, 4, 5, 6, 10, 14 or 21, or the option unit: one of {}",
        path, *drawing.insunits, length_unit_names()));
  return *unit;
}

void DxfImporter::expect_building(const std::string& path, const LengthUnit& unit, double size_m) {
  if (size_m >= kSmallestBuilding_m) return;
  throw MapError(fmt::format(
      "{}: what has a class is {:.2f} m large in {}, as $INSUNITS says, expected a building of at least {:.0f} m; the "
      "option unit says what it is drawn in: one of {}",
      path, size_m, unit.name, kSmallestBuilding_m, length_unit_names()));
}

MapImport DxfImporter::import(const std::string& path) const {
  const DxfDrawing drawing = read_dxf(path);
  const std::vector<PlacedEntity> entities = expand_blocks(path, drawing);
  expect_classes(path, drawing, entities);
  const LengthUnit unit = unit_of(path, drawing);
  ShapeOptions shape = shape_;
  shape.metres_per_unit = unit.metres;
  EntitySorting first = sorted(drawing, entities, shape);
  expect_perceivable(path, drawing, first);
  const Eigen::AlignedBox2d bounds = bounds_of(first.elements);
  if (!unit_) expect_building(path, unit, bounds.sizes().maxCoeff());
  const Point far_m = shape.origin_m.isZero() ? origin_of_far_plan(bounds.min(), bounds.max()) : Point::Zero();
  if (!far_m.isZero()) shape.origin_m = far_m;
  EntitySorting sorting = far_m.isZero() ? std::move(first) : sorted(drawing, entities, shape);

  const PlanAssembly assembly = assemble_plan(path, name_of(path), sorting.elements, plan_.plan);
  expect_features(path, sorting, *assembly.map, plan_.plan.min_face_m);
  MapImport imported{assembly.map, {}, std::move(sorting.things), {}};
  report_outcomes(sorting.elements, assembly, imported.elements);
  sort_by_id(imported.elements);

  imported.report.push_back("drawing in " + unit.name + (unit_ ? ", as the option unit says" : ", as $INSUNITS says"));
  if (unit_ && drawing.insunits && *drawing.insunits != 0 &&
      unit_of_insunits(*drawing.insunits).value_or(LengthUnit{}).name != unit.name)
    imported.report.push_back(fmt::format("doubtful: $INSUNITS {} says another unit", *drawing.insunits));
  if (!far_m.isZero()) imported.report.push_back(sentence_about_far_origin(far_m));
  imported.report.push_back(extent_sentence(*assembly.map));
  if (!unit_ && bounds.sizes().maxCoeff() < kSmallBuilding_m)
    imported.report.push_back(fmt::format("doubtful: what has a class is {:.1f} m large, is {} the right unit?",
                                          bounds.sizes().maxCoeff(), unit.name));
  for (const std::string& sentence : sorting.tally.sentences()) imported.report.push_back(sentence);
  for (const std::string& pattern : plan_.rules.unused(sorting.tally.classes()))
    imported.report.push_back("doubtful: no layer is called '" + pattern + "', as a rule of the option classes has it");
  for (const std::string& sentence : about_drawing(sorting, drawing)) imported.report.push_back(sentence);
  for (const std::string& sentence : assembly.tally.sentences(plan_.plan)) imported.report.push_back(sentence);
  for (const std::string& doubt :
       doubts_about(sorting.elements, door_strokes(sorting), assembly, plan_.plan, unit, !unit_))
    imported.report.push_back(doubt);
  return imported;
}

}  // namespace opal::dxf_importer
