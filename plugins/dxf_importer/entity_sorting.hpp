#pragma once

#include "closed_doors.hpp"
#include "layer_classes.hpp"
#include "shapes.hpp"

#include <opal/import_kit/class_tally.hpp>
#include <opal/import_kit/plan_import.hpp>
#include <opal/import_kit/wide_walls.hpp>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace opal::dxf_importer {

/// Sorts the entities of a drawing by what shall become of them.
class EntitySorting {
 public:
  EntitySorting(const PlanImportOptions& plan, const LayerClasses& classes, const ShapeOptions& shape,
                const DxfDrawing& drawing)
      : plan_(plan), classes_(classes), shape_(shape), drawing_(drawing) {}

  /// @throws MapError if the entity is damaged and something should become of it.
  void add(const PlacedEntity& placed);
  /// Gives walls that are drawn by their middles the thickness that they are drawn with.
  void finish();

  std::vector<PlanElement> elements;
  std::vector<ImportedElement> things;
  std::vector<DoorStroke> perhaps_doors;  ///< open lines of no class, in the map's frame
  ClassTally tally{"layer"};
  std::set<std::string> walls_of_layer_0;  ///< names of blocks whose lines became walls since they are on layer 0
  int refitted = 0, chorded = 0, open_loops = 0;
  int wide = 0;        ///< polylines that are walls as thick as they are drawn
  int oddly_wide = 0;  ///< polylines of which the middle was taken, since no wall is so thick

 private:
  const std::optional<std::string>& class_of(const std::string& layer);
  std::string block_that_is_no_wall(const PlacedEntity& placed);
  std::string why_not_drawn(const PlacedEntity& placed) const;
  std::string thing_of(const PlacedEntity& placed, const std::string& type);
  void add_perhaps_a_door(const PlacedEntity& placed);
  std::string use(const PlacedEntity& placed, const std::string& type);
  void use_width(const std::string& type, double width_m, Shapes& shapes);
  PlanElement& element_for(const PlacedEntity& placed, const std::string& type);
  void leave_out(const PlacedEntity& placed, const std::string& why, ImportStatus status);

  const PlanImportOptions& plan_;
  const LayerClasses& classes_;
  const ShapeOptions& shape_;
  const DxfDrawing& drawing_;
  std::map<std::string, std::size_t> parts_;
  std::map<std::string, std::optional<std::string>> class_of_layer_;
  std::vector<WidePiece> wide_pieces_;
  std::vector<std::size_t> element_of_piece_;
};

}  // namespace opal::dxf_importer
