#pragma once

#include "geojson_reader.hpp"
#include "placement.hpp"
#include "plan_elements.hpp"

#include <opal/import_kit/plan_import.hpp>

#include <string>
#include <vector>

namespace opal::geojson_importer {

/// Makes a map of areas, lines and points with properties: a plan in metres or in degrees.
class GeoJsonImporter final : public MapImporter {
 public:
  explicit GeoJsonImporter(const nlohmann::json& options);

  bool recognizes(const std::string& path) const override;
  MapImport import(const std::string& path) const override;
  std::vector<Storey> storeys(const std::string& path) const override;

 private:
  /// A plan whose features know their levels and types, and whether something becomes of them on any level.
  FeatureCollection plan_at(const std::string& path, const std::string& level_property) const;
  /// With the origin that another plan gives.
  PlacementOptions placement() const;
  /// What only the assembled map shows. @throws MapError if it holds nothing.
  void expect_features(const std::string& path, const SemanticMap& map) const;
  /// The level to import; empty: there is one only. @throws MapError if the option names none.
  std::string chosen_level(const std::string& path, const FeatureCollection& collection,
                           std::vector<std::string>& sentences) const;
  /// With what says the type of a feature that words of it gave.
  FeatureClasses shown_classes(const Feature& feature) const;
  PlanElements elements_of(const std::string& path, const FeatureCollection& collection,
                           const std::string& level) const;

  PlanImportOptions plan_;
  std::string storey_, class_property_, level_property_;
  ElementOptions elements_;
  PlacementOptions placement_;
};

}  // namespace opal::geojson_importer
