#pragma once

#include <opal/map/map_importer.hpp>

#include <string>

/// Whether a map holds, or its report names, all that a text holds: counted in the text in another way than importers
/// do. Each returns what is missing; "" if nothing is.

std::string whole_dxf(const opal::MapImport& imported, const std::string& text);
std::string whole_geojson(const opal::MapImport& imported, const std::string& text);
std::string whole_map(const opal::SemanticMap& map, const std::string& text);
std::string whole_ifc(const opal::MapImport& imported, const std::string& text);
