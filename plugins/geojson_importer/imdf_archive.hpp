#pragma once

#include "geojson_reader.hpp"

#include <string>

namespace opal::geojson_importer {

/// Whether a path is a folder that holds an archive of Apple's Indoor Mapping Data Format: unit.geojson, level.geojson.
bool is_imdf_archive(const std::string& path);

/// Reads a plan: one file, or all files of the archive that it belongs to, since units, their openings and the names of
/// levels stand in files of their own. Units are then on the level that their ordinal says.
/// @throws MapError "PATH: POINTER: what was found, what was expected".
FeatureCollection read_plan(const std::string& path);

}  // namespace opal::geojson_importer
