#pragma once

#include "osm_extract.hpp"

#include <string>

namespace opal::geojson_importer {

/// Reads OpenStreetMap's XML, as JOSM, the site and Overpass write it. What an editor has marked as deleted is not
/// read.
/// @throws MapError "PATH:LINE: what was found, what was expected".
OsmExtract read_osm_xml(const std::string& path);

/// Reads the JSON of Overpass: nodes, ways and relations, with the positions of ways in nodes or in `geometry`.
/// @throws MapError "PATH: POINTER: what was found, what was expected".
OsmExtract read_overpass(const nlohmann::json& document, const std::string& path);

}  // namespace opal::geojson_importer
