#pragma once

#include <string>

namespace opal::geojson_importer {

/// Whether a file looks like GeoJSON or like what OpenStreetMap hands out: by its ending, in upper or lower case, and
/// by its first and last 4 KiB. False if it cannot be read.
bool looks_like_plan(const std::string& path);

/// The formats of OpenStreetMap itself: XML, and the JSON of Overpass.
enum class OsmForm { none, xml, json };

OsmForm osm_form_of(const std::string& path);

}  // namespace opal::geojson_importer
