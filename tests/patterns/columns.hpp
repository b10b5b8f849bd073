#pragma once

#include "tests/kit/shipped_plugins.hpp"

#include <opal/map/view/map_view.hpp>

#include <catch2/catch.hpp>

#include <memory>
#include <string>
#include <vector>

/// A template as shipped, by its type name.
inline std::shared_ptr<const opal::PatternTemplate> shipped(const std::string& name,
                                                            const nlohmann::json& options = nlohmann::json::object()) {
  return shipped_plugins().make<opal::PatternTemplate>(name, options);
}

inline opal::Feature column(double x, double y, double radius_m = 0.33) {
  return {"opal:Column", opal::Circle{{x, y}, radius_m}};
}
/// @param heading_rad  of the bisector; the corner is a room's unless told.
inline opal::Feature corner(double x, double y, double heading_rad, double opening_rad = 0.5 * std::numbers::pi) {
  return {"opal:Corner", opal::OrientedPoint{{x, y}, heading_rad, opening_rad}};
}
inline opal::Feature wall(double x0, double y0, double x1, double y1) {
  return {"opal:Wall", opal::Segment{{x0, y0}, {x1, y1}}};
}

/// A map that a "lidar" perceives, one object per feature: "k1", "k2", ... in the order given.
inline std::shared_ptr<const opal::SemanticMap> map_of(const std::vector<opal::Feature>& features,
                                                       std::vector<opal::MapPattern> patterns = {}) {
  std::vector<opal::MapObject> objects;
  std::vector<opal::MapFeature> mapped;
  for (std::size_t k = 0; k < features.size(); ++k) {
    const std::string id = "k" + std::to_string(k + 1);
    objects.push_back({id, features[k].type});
    opal::MapFeature feature;
    feature.id = id + "-shape";
    feature.object = opal::MapObjectNumber(k);
    feature.type = features[k].type;
    feature.sensor = "lidar";
    feature.geometry = features[k].geometry;
    mapped.push_back(feature);
  }
  return opal::SemanticMap::make("columns", objects, mapped, std::move(patterns));
}

inline opal::MapView view_of(const std::shared_ptr<const opal::SemanticMap>& map) { return {map, "lidar"}; }

/// The hall of the thesis: two rows of columns, 7.4 m apart in x and 6.2 m in y.
inline std::vector<opal::Feature> column_grid(int columns, int rows) {
  std::vector<opal::Feature> features;
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k < columns; ++k) features.push_back(column(7.4 * k, 6.2 * row));
  return features;
}
