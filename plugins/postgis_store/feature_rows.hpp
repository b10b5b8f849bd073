#pragma once

#include <opal/common/geometry.hpp>
#include <opal/map/semantic_map.hpp>

#include <string>
#include <vector>

namespace opal::postgis_store {

/// Features as rows of the table opal.features: a JSON object per feature, which kInsertFeatures takes an array of.
std::vector<std::string> feature_rows(const SemanticMap& map);

/// $1: id of the map version; $2: array of rows.
extern const char* const kInsertFeatures;

/// The circles' largest radius, 0 without circles.
double largest_radius_m(const SemanticMap& map);

/// The columns of a geometry, in the order that geometry_of takes them.
extern const char* const kGeometryColumns;
/// @param columns  the first one's position in a row. Exact: the numbers that were pushed.
Geometry geometry_of(const std::vector<std::string>& row, std::size_t columns);

}  // namespace opal::postgis_store
