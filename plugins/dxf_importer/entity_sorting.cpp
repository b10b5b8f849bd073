#include "entity_sorting.hpp"

#include <opal/common/error.hpp>

#include <algorithm>

namespace opal::dxf_importer {
namespace {

// On which programs draw unless they are told otherwise.
constexpr const char* kLayer0 = "0";
// No leaf and no swing has so many.
constexpr std::size_t kMaxDoorPoints = 64;
// A pane is thicker.
constexpr double kThinnestWall_m = 0.02;
// Numbers of the outlines of wide walls: those of hatches are lower.
constexpr int kFirstPiece = 1'000'000;

std::string why_no_class(const std::optional<std::string>& type) {
  if (!type) return "no class for its layer";
  return *type == ClassRules::kLeaveOut ? "a rule for its layer says so" : "";
}

std::string id_of(const PlacedEntity& placed) {
  return placed.insert.empty() ? placed.entity->id : placed.insert + "/" + placed.entity->id;
}

}  // namespace

void EntitySorting::add(const PlacedEntity& placed) {
  if (const std::string block = block_that_is_no_wall(placed); !block.empty()) {
    PlacedEntity renamed = placed;
    renamed.layer = block;
    return add(renamed);
  }
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

const std::optional<std::string>& EntitySorting::class_of(const std::string& layer) {
  const auto [known, is_new] = class_of_layer_.emplace(layer, std::nullopt);
  if (is_new) known->second = classes_.class_of(layer);
  return known->second;
}

/// Where everything is on layer 0, and a rule makes walls of it, the name of a block may say that it is a door, a
/// window, or nothing for the map. Empty: no name says so.
std::string EntitySorting::block_that_is_no_wall(const PlacedEntity& placed) {
  if (placed.layer != kLayer0 || placed.blocks.empty() || !why_not_drawn(placed).empty()) return "";
  const std::optional<std::string> type = class_of(kLayer0);
  if (type != "opal:Wall" && type != "opal:Column") return "";
  for (auto block = placed.blocks.rbegin(); block != placed.blocks.rend(); ++block) {
    const std::optional<std::string>& said = class_of(*block);
    if (said && said != "opal:Wall" && said != "opal:Column" && *block != kLayer0) return *block;
  }
  walls_of_layer_0.insert(placed.blocks.back());
  return "";
}

std::string EntitySorting::why_not_drawn(const PlacedEntity& placed) const {
  if (placed.entity->is_in_paper_space) return "it is on a sheet, not in the model";
  if (placed.entity->is_hidden) return "it is hidden";
  if (placed.is_frozen) return "its layer is frozen";
  if (const auto layer = drawing_.layers.find(placed.layer); layer != drawing_.layers.end() && layer->second.is_off)
    return "its layer is off";
  return "";
}

/// Lines of one block that are no wall are one thing: the leaf and the swing of a door. A block that lies on a layer
/// of doors is one door with all that is in it.
std::string EntitySorting::thing_of(const PlacedEntity& placed, const std::string& type) {
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
void EntitySorting::add_perhaps_a_door(const PlacedEntity& placed) {
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

std::string EntitySorting::use(const PlacedEntity& placed, const std::string& type) {
  if (!placed.trouble.empty()) return placed.trouble;
  if (!placed.entity->trouble.empty()) return placed.entity->trouble;
  Shapes shapes;
  const std::string trouble =
      add_shape(placed, shape_, type == "opal:Column" ? PlanSides::solid : PlanSides::to_find, shapes);
  if (!trouble.empty()) return trouble;
  tally.count_used(placed.layer, type, placed.entity->type);
  refitted += shapes.refitted;
  chorded += shapes.chorded;
  if (const auto* fill = std::get_if<DxfFill>(&placed.entity->shape)) open_loops += fill->open_loops;
  PlanElement& element = element_for(placed, type);
  if (shapes.width_m > 0) use_width(type, shapes.width_m, shapes);
  std::move(shapes.lines.begin(), shapes.lines.end(), std::back_inserter(element.lines));
  std::move(shapes.circles.begin(), shapes.circles.end(), std::back_inserter(element.circles));
  return "";
}

/// Of a polyline that was drawn with a width: its pieces wait for all others. A ring (DONUT) is a round column up to
/// its outer rim.
void EntitySorting::use_width(const std::string& type, double width_m, Shapes& shapes) {
  if (!shapes.circles.empty()) {
    for (Circle& circle : shapes.circles) circle.radius_m += width_m / 2;
    return;
  }
  if (type != "opal:Wall" || width_m < kThinnestWall_m || width_m > plan_.plan.max_wall_thickness_m) {
    oddly_wide += type == "opal:Wall" || type == "opal:Column";
    return;
  }
  ++wide;
  for (const PlanLine& line : shapes.lines)
    for (std::size_t k = 0; k + (line.closed ? 0 : 1) < line.points.size(); ++k) {
      const Point &begin = line.points[k], &end = line.points[(k + 1) % line.points.size()];
      if (begin == end) continue;
      wide_pieces_.push_back({{begin, end}, width_m});
      element_of_piece_.push_back(elements.size() - 1);
    }
  shapes.lines.clear();
}

void EntitySorting::finish() {
  const auto outlines = widened(wide_pieces_);
  for (std::size_t k = 0; k < outlines.size(); ++k)
    elements[element_of_piece_[k]].lines.push_back(
        {outlines[k], true, PlanSides::solid, kFirstPiece + static_cast<int>(k)});
}

PlanElement& EntitySorting::element_for(const PlacedEntity& placed, const std::string& type) {
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

void EntitySorting::leave_out(const PlacedEntity& placed, const std::string& why, ImportStatus status) {
  tally.count_left_out(placed.layer, why, placed.entity->type, id_of(placed));
  things.push_back({id_of(placed), placed.layer, placed.entity->type, status, why});
}

}  // namespace opal::dxf_importer
