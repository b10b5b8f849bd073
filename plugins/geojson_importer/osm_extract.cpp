#include "osm_extract.hpp"

#include <opal/import_kit/first_ids.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace opal::geojson_importer {
namespace {

using nlohmann::json;
using Tags = std::map<std::string, std::string>;
using Line = std::vector<OsmPosition>;

// Ways that are lines though they may come back to where they began.
constexpr std::array kLinear{"highway", "railway", "waterway", "route"};
// Of a relation: more are a country, not a room.
constexpr std::size_t kMostMembers = 2000;

std::string tag(const Tags& tags, const std::string& key) {
  const auto found = tags.find(key);
  return found == tags.end() ? "" : found->second;
}

bool is_area(const Tags& tags) {
  const std::string area = tag(tags, "area");
  if (area == "yes" || area == "no") return area == "yes";
  return tags.contains("indoor") || std::ranges::none_of(kLinear, [&](const char* key) { return tags.contains(key); });
}

json coordinates(const Line& line) {
  json positions = json::array();
  for (const auto& [longitude, latitude] : line) positions.push_back({longitude, latitude});
  return positions;
}

class Features {
 public:
  explicit Features(const OsmExtract& extract) : extract_(extract) {
    for (const auto& [id, relation] : extract_.relations) note_level(relation);
  }

  json run(std::vector<std::string>& notes) {
    for (const auto& [id, node] : extract_.nodes)
      if (!node.tags.empty()) add("node", id, node.tags, "Point", {node.position.first, node.position.second});
    for (const auto& [id, way] : extract_.ways)
      if (!way.tags.empty()) add_way(id, way);
    for (const auto& [id, relation] : extract_.relations)
      if (tag(relation.tags, "type") == "multipolygon") add_multipolygon(id, relation);
    if (!incomplete_.empty())
      notes.push_back(fmt::format("left out: ways and multipolygons of which the file holds a part only: {} ({})",
                                  incomplete_.size(), first_of(incomplete_)));
    return {{"type", "FeatureCollection"}, {"features", std::move(features_)}};
  }

 private:
  void note_level(const OsmRelation& relation) {
    const std::string level = tag(relation.tags, "level");
    if (tag(relation.tags, "type") != "level" || level.empty()) return;
    for (const OsmMember& member : relation.members) {
      std::string& levels = level_of_[member.type + "/" + std::to_string(member.id)];
      levels += (levels.empty() ? "" : ";") + level;
    }
  }

  void add(const std::string& type, std::int64_t number, const Tags& tags, const char* geometry, json coordinates) {
    const std::string id = type + "/" + std::to_string(number);
    json properties = tags;
    if (const auto level = level_of_.find(id); level != level_of_.end() && !tags.contains("level"))
      properties["level"] = level->second;
    features_.push_back({{"type", "Feature"},
                         {"id", id},
                         {"properties", std::move(properties)},
                         {"geometry", {{"type", geometry}, {"coordinates", std::move(coordinates)}}}});
  }

  /// Nothing if a node is missing.
  std::optional<Line> line_of(const OsmWay& way) const {
    if (!way.positions.empty()) return way.positions;
    Line line;
    for (const std::int64_t id : way.nodes) {
      const auto node = extract_.nodes.find(id);
      if (node == extract_.nodes.end()) return std::nullopt;
      line.push_back(node->second.position);
    }
    return line;
  }

  void add_way(std::int64_t id, const OsmWay& way) {
    const std::optional<Line> line = line_of(way);
    if (!line || line->size() < 2) return incomplete_.push_back("way/" + std::to_string(id));
    if (line->size() > 3 && line->front() == line->back() && is_area(way.tags))
      add("way", id, way.tags, "Polygon", json::array({coordinates(*line)}));
    else
      add("way", id, way.tags, "LineString", coordinates(*line));
  }

  /// Rings of the members with a role; nothing if they do not close.
  std::optional<std::vector<Line>> rings_of(const OsmRelation& relation, bool inner) const {
    std::vector<Line> parts;
    if (relation.members.size() > kMostMembers) return std::nullopt;
    for (const OsmMember& member : relation.members) {
      if (member.type != "way" || (member.role == "inner") != inner) continue;
      const auto way = extract_.ways.find(member.id);
      std::optional<Line> line = way == extract_.ways.end() ? std::nullopt : line_of(way->second);
      if (!line || line->size() < 2) return std::nullopt;
      parts.push_back(std::move(*line));
    }
    std::vector<Line> rings;
    while (!parts.empty()) {
      Line ring = std::move(parts.back());
      parts.pop_back();
      while (ring.front() != ring.back())
        if (!extend(ring, parts)) return std::nullopt;
      rings.push_back(std::move(ring));
    }
    return rings;
  }

  /// Adds a part to the end of a line where one begins or ends there.
  static bool extend(Line& ring, std::vector<Line>& parts) {
    const auto next = std::ranges::find_if(
        parts, [&](const Line& part) { return part.front() == ring.back() || part.back() == ring.back(); });
    if (next == parts.end()) return false;
    if (next->front() != ring.back()) std::ranges::reverse(*next);
    ring.insert(ring.end(), next->begin() + 1, next->end());
    parts.erase(next);
    return true;
  }

  static bool is_in(const OsmPosition& p, const Line& ring) {
    bool inside = false;
    for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
      const auto &a = ring[k], &b = ring[k + 1];
      if ((a.second > p.second) != (b.second > p.second) &&
          p.first < a.first + (b.first - a.first) * (p.second - a.second) / (b.second - a.second))
        inside = !inside;
    }
    return inside;
  }

  void add_multipolygon(std::int64_t id, const OsmRelation& relation) {
    if (relation.tags.size() < 2) return;  // old ones have their tags on the outer way, which is a feature already
    const auto outer = rings_of(relation, false), inner = rings_of(relation, true);
    if (!outer || outer->empty() || !inner) return incomplete_.push_back("relation/" + std::to_string(id));
    json polygons = json::array();
    for (const Line& ring : *outer) {
      json polygon = json::array({coordinates(ring)});
      for (const Line& hole : *inner)
        if (is_in(hole.front(), ring)) polygon.push_back(coordinates(hole));
      polygons.push_back(std::move(polygon));
    }
    Tags tags = relation.tags;
    tags.erase("type");
    add("relation", id, tags, "MultiPolygon", std::move(polygons));
  }

  const OsmExtract& extract_;
  std::map<std::string, std::string> level_of_;  ///< of members of relations
  json features_ = json::array();
  std::vector<std::string> incomplete_;
};

}  // namespace

json geojson_of(const OsmExtract& extract, std::vector<std::string>& notes) { return Features(extract).run(notes); }

}  // namespace opal::geojson_importer
