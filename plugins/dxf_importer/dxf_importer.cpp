#include "dxf_importer.hpp"

#include <opal/common/error.hpp>
#include <opal/import_kit/class_tally.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace opal::dxf_importer {
namespace {

/// Layer names by the US National CAD Standard (AIA; "PLAN$0$A-WALL" in a bound reference), ISO 13567 with SfB
/// elements, and plain words.
const std::map<std::string, std::string>& default_classes() {
  static const std::map<std::string, std::string> kClasses{{"*-WALL*", "Wall"},
                                                           {"WALL*", "Wall"},
                                                           {"*_WALL*", "Wall"},
                                                           {"*WALLS", "Wall"},
                                                           {"*MUREN*", "Wall"},
                                                           {"*WAND", "Wall"},
                                                           {"*WAENDE*", "Wall"},
                                                           {"A-21*", "Wall"},
                                                           {"A-22*", "Wall"},
                                                           {"*-COLS*", "Column"},
                                                           {"*COLUMN*", "Column"},
                                                           {"*KOLOM*", "Column"},
                                                           {"*STUETZE*", "Column"},
                                                           {"A-28*", "Column"},
                                                           {"*-DOOR*", "Door"},
                                                           {"*DOORS", "Door"},
                                                           {"DOOR*", "Door"},
                                                           {"*DEUREN*", "Door"},
                                                           {"*TUEREN*", "Door"},
                                                           {"A-32*", "Door"},
                                                           {"*-GLAZ*", "Window"},
                                                           {"*WINDOW*", "Window"},
                                                           {"*FENSTER*", "Window"},
                                                           {"*KOZIJN*", "Window"},
                                                           {"A-31*", "Window"},
                                                           {"*-WALL-HEAD*", "leave_out"},
                                                           {"*-WALL-CNTR*", "leave_out"},
                                                           {"*-WALL-IDEN*", "leave_out"},
                                                           {"*-WALL-ABOV*", "leave_out"},
                                                           {"*-COLS-GRID*", "leave_out"},
                                                           {"*-COLS-IDEN*", "leave_out"},
                                                           {"*-DOOR-IDEN*", "leave_out"},
                                                           {"*-GLAZ-IDEN*", "leave_out"}};
  return kClasses;
}

/// "plans/office.dxf" is called "office".
std::string name_of(const std::string& path) {
  const std::string name = std::filesystem::path(path).stem().string();
  return name.empty() ? "drawing" : name;
}

/// Sorts the entities of a drawing by what shall become of them.
class Sorting {
 public:
  Sorting(const PlanImportOptions& plan, const ShapeOptions& shape, const DxfDrawing& drawing)
      : plan_(plan), shape_(shape), drawing_(drawing) {}

  void add(const PlacedEntity& placed) {
    const std::optional<std::string> type = plan_.rules.class_of(placed.layer);
    const std::string why = why_left_out(placed, type);
    if (!why.empty())
      leave_out(placed, why, ImportStatus::left_out);
    else if (const std::string trouble = use(placed, *type); !trouble.empty())
      leave_out(placed, trouble, ImportStatus::unreadable);
  }

  std::vector<PlanElement> elements;
  std::vector<ImportedElement> things;
  ClassTally tally{"layer"};
  int refitted = 0, chorded = 0, wide = 0;

 private:
  std::string why_left_out(const PlacedEntity& placed, const std::optional<std::string>& type) const {
    if (placed.entity->is_in_paper_space) return "it is on a sheet, not in the model";
    if (placed.is_frozen) return "its layer is frozen";
    if (const auto layer = drawing_.layers.find(placed.layer); layer != drawing_.layers.end() && layer->second.is_off)
      return "its layer is off";
    if (!type) return "no class for its layer";
    return *type == ClassRules::kLeaveOut ? "a rule for its layer says so" : "";
  }

  static std::string id_of(const PlacedEntity& placed) {
    return placed.insert.empty() ? placed.entity->id : placed.insert + "/" + placed.entity->id;
  }

  /// Lines of one block that are no wall are one thing: the leaf and the swing of a door.
  static bool is_part_of_insert(const PlacedEntity& placed, const std::string& type) {
    const auto* path = std::get_if<DxfPath>(&placed.entity->shape);
    const DxfShape& shape = placed.entity->shape;
    const bool is_open = (path != nullptr && !path->closed) || std::holds_alternative<DxfArc>(shape) ||
                         std::holds_alternative<DxfEllipse>(shape) || std::holds_alternative<BSpline>(shape);
    return !placed.insert.empty() && type != "opal:Wall" && is_open;
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
    PlanElement& element = element_for(placed, type);
    std::move(shapes.lines.begin(), shapes.lines.end(), std::back_inserter(element.lines));
    std::move(shapes.circles.begin(), shapes.circles.end(), std::back_inserter(element.circles));
    return "";
  }

  PlanElement& element_for(const PlacedEntity& placed, const std::string& type) {
    const bool is_part = is_part_of_insert(placed, type);
    const std::string id = is_part ? placed.insert + "/" + placed.layer : id_of(placed);
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
  const ShapeOptions& shape_;
  const DxfDrawing& drawing_;
  std::map<std::string, std::size_t> parts_;
};

}  // namespace

DxfImporter::DxfImporter(const nlohmann::json& options) : plan_(options, default_classes()) {
  shape_.origin_m = {options.at("origin_x_m").get<double>(), options.at("origin_y_m").get<double>()};
  shape_.circle_tolerance_m = options.at("circle_tolerance_m");
  shape_.max_column_radius_m = options.at("max_column_radius_m");
  const std::string name = options.at("unit");
  unit_ = unit_called(name);
  if (!unit_ && !name.empty())
    throw ConfigError("opal:DxfImporter: option unit: \"" + name + "\", expected one of: " + unit_names());
}

bool DxfImporter::recognizes(const std::string& path) const {
  std::error_code error;
  const std::string extension = upper_case(std::filesystem::path(path).extension().string());
  return (extension == ".DXF" || extension == ".DWG") && std::filesystem::is_regular_file(path, error);
}

Unit DxfImporter::unit_of(const std::string& path, const DxfDrawing& drawing) const {
  if (unit_) return *unit_;
  if (!drawing.insunits || *drawing.insunits == 0)
    throw MapError(path + ": does not say in which unit it is drawn ($INSUNITS), expected the option unit: one of " +
                   unit_names());
  const std::optional<Unit> unit = unit_of_insunits(*drawing.insunits);
  if (!unit)
    throw MapError(fmt::format(
        "{}: is drawn in the unit $INSUNITS {}, expected 1, 2, 4, 5, 6, 10 or 14, or the option unit: one of {}", path,
        *drawing.insunits, unit_names()));
  return *unit;
}

MapImport DxfImporter::import(const std::string& path) const {
  const DxfDrawing drawing = read_dxf(path);
  const Unit unit = unit_of(path, drawing);
  ShapeOptions shape = shape_;
  shape.metres_per_unit = unit.metres;
  Sorting sorting(plan_, shape, drawing);
  for (const PlacedEntity& placed : expand_blocks(path, drawing)) sorting.add(placed);
  if (sorting.elements.empty())
    throw MapError(path + ": no layer gives anything for a map, expected the option classes to name one of: " +
                   sorting.tally.overview());

  const PlanAssembly assembly = assemble_plan(path, name_of(path), sorting.elements, plan_.plan);
  MapImport imported{assembly.map, {}, std::move(sorting.things), {}};
  report_outcomes(sorting.elements, assembly, imported.elements);
  sort_by_id(imported.elements);

  imported.report.push_back("drawing in " + unit.name + (unit_ ? ", as the option unit says" : ", as $INSUNITS says"));
  if (unit_ && drawing.insunits && *drawing.insunits != 0 &&
      unit_of_insunits(*drawing.insunits).value_or(Unit{}).name != unit.name)
    imported.report.push_back(fmt::format("doubtful: $INSUNITS {} says another unit", *drawing.insunits));
  imported.report.push_back(extent_sentence(*assembly.map));
  for (const std::string& sentence : sorting.tally.sentences()) imported.report.push_back(sentence);
  for (const std::string& pattern : plan_.rules.unused(sorting.tally.classes()))
    imported.report.push_back("doubtful: no layer is called '" + pattern + "', as a rule of the option classes has it");
  if (sorting.refitted > 0)
    imported.report.push_back(fmt::format("circles that were drawn as closed lines: {}", sorting.refitted));
  if (sorting.chorded > 0)
    imported.report.push_back(
        fmt::format("curved lines that became short straight ones, at most 5 mm off: {}", sorting.chorded));
  if (sorting.wide > 0)
    imported.report.push_back(fmt::format(
        "doubtful: polylines that are drawn with a width, of which the middle was taken: {}", sorting.wide));
  for (const std::string& sentence : assembly.tally.sentences(plan_.plan)) imported.report.push_back(sentence);
  return imported;
}

}  // namespace opal::dxf_importer
