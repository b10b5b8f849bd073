#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace opal::geojson_importer {

/// Longitude and latitude [deg].
using OsmPosition = std::pair<double, double>;

struct OsmNode {
  OsmPosition position;
  std::map<std::string, std::string> tags;
};

struct OsmWay {
  std::vector<std::int64_t> nodes;
  std::vector<OsmPosition> positions;  ///< of these, where the file gives no nodes of their own
  std::map<std::string, std::string> tags;
};

struct OsmMember {
  std::string type, role;  ///< "way", "outer"
  std::int64_t id = 0;
};

struct OsmRelation {
  std::vector<OsmMember> members;
  std::map<std::string, std::string> tags;
};

/// What a file of OpenStreetMap holds, as XML or as JSON.
struct OsmExtract {
  std::map<std::int64_t, OsmNode> nodes;
  std::map<std::int64_t, OsmWay> ways;
  std::map<std::int64_t, OsmRelation> relations;
};

/// Makes a FeatureCollection of GeoJSON of an extract, as osmtogeojson does: ids are "way/5"; tags are properties;
/// closed ways and multipolygons are polygons; members of a relation of type=level without a level have its level.
/// Nodes without tags are no features.
/// @param notes  gets a sentence about what the file holds in part only, which is left out.
nlohmann::json geojson_of(const OsmExtract& extract, std::vector<std::string>& notes);

}  // namespace opal::geojson_importer
