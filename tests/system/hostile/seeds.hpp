#pragma once

#include <string>
#include <vector>

/// Small files that are in order, to be damaged.

std::vector<std::string> dxf_seeds();
std::vector<std::string> geojson_seeds();
std::vector<std::string> map_seeds();

/// A drawn building, and small real ones of ../shared where that is there.
std::vector<std::string> ifc_seeds();
