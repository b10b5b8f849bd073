#pragma once

#include "block_expansion.hpp"
#include "entity_sorting.hpp"
#include "unit.hpp"

#include <opal/import_kit/plan_import.hpp>

namespace opal::dxf_importer {

/// Makes a map of a drawing: layers say what things are.
class DxfImporter final : public MapImporter {
 public:
  explicit DxfImporter(const nlohmann::json& options);

  bool recognizes(const std::string& path) const override;
  MapImport import(const std::string& path) const override;

 private:
  /// @throws MapError if the unit that the drawing says makes it smaller than any building.
  static void expect_building(const std::string& path, const LengthUnit& unit, double size_m);
  /// A unit is not worth asking for if nothing becomes of the drawing anyhow.
  /// @throws MapError if the drawing says no unit, and no layer of it gives anything.
  void expect_classes(const std::string& path, const DxfDrawing& drawing,
                      const std::vector<PlacedEntity>& entities) const;
  EntitySorting sorted(const DxfDrawing& drawing, const std::vector<PlacedEntity>& entities,
                       const ShapeOptions& shape) const;
  LengthUnit unit_of(const std::string& path, const DxfDrawing& drawing) const;

  PlanImportOptions plan_;
  LayerClasses classes_;
  ShapeOptions shape_;
  std::optional<LengthUnit> unit_;  ///< as an option says; none: as the drawing says
};

}  // namespace opal::dxf_importer
