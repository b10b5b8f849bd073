#include "dxf_importer.hpp"

#include "doubts.hpp"
#include "layer_classes.hpp"

#include <opal/common/error.hpp>
#include <opal/common/letter_case.hpp>
#include <opal/import_kit/class_tally.hpp>

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <filesystem>
#include <map>

namespace opal::dxf_importer {
namespace {

// A drawing that says mm and is one in inches becomes a building of a metre.
constexpr double kSmallestBuilding_m = 2;
// No leaf and no swing has so many.
constexpr std::size_t kMaxDoorPoints = 64;

/// Width or depth of everything that shall become map, whichever is larger.
double extent_m(const std::vector<PlanElement>& elements) {
  Eigen::AlignedBox2d box;
  for (const PlanElement& element : elements) {
    for (const PlanLine& line : element.lines)
      for (const Point& p : line.points) box.extend(p);
    for (const Circle& circle : element.circles) {
      const Point radius = Point::Constant(circle.radius_m);
      box.extend(circle.center - radius).extend(circle.center + radius);
    }
  }
  return box.sizes().maxCoeff();
}

/// "plans/office.dxf" is called "office".
std::string name_of(const std::string& path) {
  const std::string name = std::filesystem::path(path).stem().string();
  return name.empty() ? "drawing" : name;
}

/// Sorts the entities of a drawing by what shall become of them.
class Sorting {
 public:
  Sorting(const PlanImportOptions& plan, const LayerClasses& classes, const ShapeOptions& shape,
          const DxfDrawing& drawing)
      : plan_(plan), classes_(classes), shape_(shape), drawing_(drawing) {}

  void add(const PlacedEntity& placed) {
    const std::optional<std::string> type = class_of(placed.layer);
    if (const std::string why = why_not_drawn(placed); !why.empty())
      return leave_out(placed, why, ImportStatus::left_out);
    if (const std::string why = why_no_class(type); !why.empty()) {
      add_perhaps_a_door(placed);
      return leave_out(placed, why, ImportStatus::left_out);
    }
    if (!placed.damage.empty()) throw MapError(placed.damage);
    if (const std::string trouble = use(placed, *type); !trouble.empty())
      leave_out(placed, trouble, ImportStatus::unreadable);
  }

  std::vector<PlanElement> elements;
  std::vector<ImportedElement> things;
  std::vector<DoorStroke> perhaps_doors;  ///< open lines of no class, in the map's frame
  ClassTally tally{"layer"};
  int refitted = 0, chorded = 0, wide = 0, open_loops = 0;

 private:
  const std::optional<std::string>& class_of(const std::string& layer) {
    const auto [known, is_new] = class_of_layer_.emplace(layer, std::nullopt);
    if (is_new) known->second = classes_.class_of(layer);
    return known->second;
  }

  std::string why_not_drawn(const PlacedEntity& placed) const {
    if (placed.entity->is_in_paper_space) return "it is on a sheet, not in the model";
    if (placed.entity->is_hidden) return "it is hidden";
    if (placed.is_frozen) return "its layer is frozen";
    if (const auto layer = drawing_.layers.find(placed.layer); layer != drawing_.layers.end() && layer->second.is_off)
      return "its layer is off";
    return "";
  }

  static std::string why_no_class(const std::optional<std::string>& type) {
    if (!type) return "no class for its layer";
    return *type == ClassRules::kLeaveOut ? "a rule for its layer says so" : "";
  }

  static std::string id_of(const PlacedEntity& placed) {
    return placed.insert.empty() ? placed.entity->id : placed.insert + "/" + placed.entity->id;
  }

  /// Lines of one block that are no wall are one thing: the leaf and the swing of a door. A block that lies on a layer
  /// of doors is one door with all that is in it.
  std::string thing_of(const PlacedEntity& placed, const std::string& type) {
    if (placed.insert.empty() || type == "opal:Wall") return "";
    if (type != "opal:Column")
      for (const auto& [insert, layer] : placed.inserts)
        if (class_of(layer) == type) return insert + "/" + layer;
    const DxfShape& shape = placed.entity->shape;
    const auto* path = std::get_if<DxfPath>(&shape);
    const bool is_open = (path != nullptr && !path->closed) || std::holds_alternative<DxfArc>(shape) ||
                         std::holds_alternative<DxfEllipse>(shape) || std::holds_alternative<BSpline>(shape);
    return is_open ? placed.insert + "/" + placed.layer : "";
  }

  /// A leaf and its swing are a door on any layer, and a wall that goes on under them is worth a word.
  void add_perhaps_a_door(const PlacedEntity& placed) {
    const DxfShape& shape = placed.entity->shape;
    const bool is_line = std::holds_alternative<DxfPath>(shape) || std::holds_alternative<DxfArc>(shape);
    if (!is_line || !placed.damage.empty() || !placed.trouble.empty()) return;
    Shapes shapes;
    if (!add_shape(placed, shape_, PlanSides::to_find, shapes).empty()) return;
    for (PlanLine& line : shapes.lines)
      if (line.points.size() <= kMaxDoorPoints)
        perhaps_doors.push_back(
            {placed.insert.empty() ? placed.entity->id : placed.insert, false, std::move(line.points)});
  }

  std::string use(const PlacedEntity& placed, const std::string& type) {
    if (!placed.trouble.empty()) return placed.trouble;
    if (!placed.entity->trouble.empty()) return placed.entity->trouble;
    Shapes shapes;
    const std::string trouble =
        add_shape(placed, shape_, type == "opal:Column" ? PlanSides::solid : PlanSides::to_find, shapes);
    if (!trouble.empty()) return trouble;
    tally.count_used(placed.layer, type, placed.entity->type);
    refitted += shapes.refitted;
    chorded += shapes.chorded;
    wide += placed.entity->has_width;
    if (const auto* fill = std::get_if<DxfFill>(&placed.entity->shape)) open_loops += fill->open_loops;
    PlanElement& element = element_for(placed, type);
    std::move(shapes.lines.begin(), shapes.lines.end(), std::back_inserter(element.lines));
    std::move(shapes.circles.begin(), shapes.circles.end(), std::back_inserter(element.circles));
    return "";
  }

  PlanElement& element_for(const PlacedEntity& placed, const std::string& type) {
    const std::string whole = thing_of(placed, type);
    const bool is_part = !whole.empty();
    const std::string id = is_part ? whole : id_of(placed);
    if (is_part)
      if (const auto known = parts_.find(id); known != parts_.end()) return elements[known->second];
    parts_[id] = elements.size();
    elements.push_back({id, type, plan_.sensor_for(type)});
    things.push_back({id, placed.layer, is_part ? "INSERT" : placed.entity->type});
    return elements.back();
  }

  void leave_out(const PlacedEntity& placed, const std::string& why, ImportStatus status) {
    tally.count_left_out(placed.layer, why, placed.entity->type, id_of(placed));
    things.push_back({id_of(placed), placed.layer, placed.entity->type, status, why});
  }

  const PlanImportOptions& plan_;
  const LayerClasses& classes_;
  const ShapeOptions& shape_;
  const DxfDrawing& drawing_;
  std::map<std::string, std::size_t> parts_;
  std::map<std::string, std::optional<std::string>> class_of_layer_;
};

/// What is drawn as a door first, then what may be one.
std::vector<DoorStroke> door_strokes(const Sorting& sorting) {
  std::vector<DoorStroke> strokes;
  for (const PlanElement& element : sorting.elements)
    for (const PlanLine& line : element.lines) {
      if (element.type == "opal:Wall" || element.type == "opal:Column") continue;
      strokes.push_back({element.id, element.type == "opal:Door", line.points});
    }
  strokes.insert(strokes.end(), sorting.perhaps_doors.begin(), sorting.perhaps_doors.end());
  return strokes;
}

/// @throws MapError if nothing that a sensor perceives comes in: no unit is to blame for that.
void expect_perceivable(const std::string& path, const Sorting& sorting) {
  const bool is_perceivable = std::any_of(sorting.elements.begin(), sorting.elements.end(),
                                          [](const PlanElement& element) { return !element.sensor.empty(); });
  if (is_perceivable) return;
  throw MapError(fmt::format("{}: no layer gives anything {}, expected the option classes to name one of: {}", path,
                             sorting.elements.empty() ? "for a map" : "that a sensor perceives",
                             sorting.tally.overview()));
}

/// @throws MapError if nothing that a sensor perceives is as long as a face: sections of profiles, symbols.
void expect_features(const std::string& path, const Sorting& sorting, const SemanticMap& map, double min_face_m) {
  const std::vector<MapFeature>& features = map.features();
  if (std::any_of(features.begin(), features.end(), [](const MapFeature& f) { return !f.sensor.empty(); })) return;
  throw MapError(
      fmt::format("{}: no line of walls and columns is {} m long or longer, expected a plan: the option unit "
                  "says what it is drawn in, and the option classes what of it is a wall: {}",
                  path, min_face_m, sorting.tally.overview()));
}

/// What is not in the map and is no entity, and what was made of curves.
std::vector<std::string> about_drawing(const Sorting& sorting, const DxfDrawing& drawing) {
  std::vector<std::string> sentences;
  const auto add = [&](int count, const char* words) {
    if (count > 0) sentences.push_back(fmt::format("{}: {}", words, count));
  };
  add(sorting.refitted, "circles that were drawn as closed lines");
  add(sorting.chorded, "curved lines that became short straight ones, at most 5 mm off");
  add(sorting.wide, "doubtful: polylines that are drawn with a width, of which the middle was taken");
  add(sorting.open_loops, "left out: loops of hatches whose edges do not meet");
  for (const std::string& block : drawing.repeated_blocks)
    sentences.push_back("left out: a second block of the same name: " + block);
  add(drawing.clips, "doubtful: clips that show a part of a block (XCLIP), and the block came in whole");
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
  Sorting sorting(plan_, classes_, shape, drawing);
  for (const PlacedEntity& placed : entities) sorting.add(placed);
  expect_perceivable(path, sorting);
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
  Sorting sorting(plan_, classes_, shape, drawing);
  for (const PlacedEntity& placed : entities) sorting.add(placed);
  expect_perceivable(path, sorting);
  if (!unit_) expect_building(path, unit, extent_m(sorting.elements));

  const PlanAssembly assembly = assemble_plan(path, name_of(path), sorting.elements, plan_.plan);
  expect_features(path, sorting, *assembly.map, plan_.plan.min_face_m);
  MapImport imported{assembly.map, {}, std::move(sorting.things), {}};
  report_outcomes(sorting.elements, assembly, imported.elements);
  sort_by_id(imported.elements);

  imported.report.push_back("drawing in " + unit.name + (unit_ ? ", as the option unit says" : ", as $INSUNITS says"));
  if (unit_ && drawing.insunits && *drawing.insunits != 0 &&
      unit_of_insunits(*drawing.insunits).value_or(LengthUnit{}).name != unit.name)
    imported.report.push_back(fmt::format("doubtful: $INSUNITS {} says another unit", *drawing.insunits));
  imported.report.push_back(extent_sentence(*assembly.map));
  for (const std::string& sentence : sorting.tally.sentences()) imported.report.push_back(sentence);
  for (const std::string& pattern : plan_.rules.unused(sorting.tally.classes()))
    imported.report.push_back("doubtful: no layer is called '" + pattern + "', as a rule of the option classes has it");
  for (const std::string& sentence : about_drawing(sorting, drawing)) imported.report.push_back(sentence);
  for (const std::string& sentence : assembly.tally.sentences(plan_.plan)) imported.report.push_back(sentence);
  for (const std::string& doubt :
       doubts_about(sorting.elements, door_strokes(sorting), assembly, plan_.plan, unit_ ? "" : unit.name))
    imported.report.push_back(doubt);
  return imported;
}

}  // namespace opal::dxf_importer
