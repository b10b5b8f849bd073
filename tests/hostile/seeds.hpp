#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// Small files that are in order, to be damaged.

std::vector<std::string> dxf_seeds();
std::vector<std::string> geojson_seeds();
std::vector<std::string> map_seeds();

/// Small real models of ../shared; none where that is absent.
std::vector<std::string> ifc_seeds();
nlohmann::json ifc_options();
