#pragma once

#include "geojson_reader.hpp"
#include "local_projection.hpp"

#include <opal/import_kit/plan_import.hpp>

#include <optional>
#include <string>

namespace opal::geojson_importer {

/// Makes a map of areas, lines and points with properties: a plan in metres, or one in degrees if it is asked for.
class GeoJsonImporter final : public MapImporter {
 public:
  explicit GeoJsonImporter(const nlohmann::json& options);

  bool recognizes(const std::string& path) const override;
  MapImport import(const std::string& path) const override;
  std::vector<Storey> storeys(const std::string& path) const override;

 private:
  /// All coordinates to metres in the `map` frame. @return sentences about it.
  std::vector<std::string> place(const std::string& path, FeatureCollection& collection) const;
  std::vector<std::string> project(const std::string& path, FeatureCollection& collection, const Point& low,
                                   const Point& high) const;
  void check_level(const std::string& path, const FeatureCollection& collection) const;

  PlanImportOptions plan_;
  std::string storey_, class_property_, radius_property_;
  bool is_geographic_ = false;
  std::optional<Point> origin_deg_;
  Point origin_m_ = Point::Zero();
  double circle_tolerance_m_ = 0.003;
  double max_column_radius_m_ = 1;
};

}  // namespace opal::geojson_importer
