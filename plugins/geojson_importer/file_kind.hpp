#pragma once

#include <string>

namespace opal::geojson_importer {

/// Whether a file looks like GeoJSON, or like what OpenStreetMap hands out, for which there is a sentence of its own:
/// by its ending, in upper or lower case, and by its first and last 4 KiB. False if it cannot be read.
bool looks_like_plan(const std::string& path);

/// @throws MapError that names a program to convert with, for OpenStreetMap's own formats: XML, and the JSON of
/// Overpass.
void refuse_openstreetmap(const std::string& path);

}  // namespace opal::geojson_importer
