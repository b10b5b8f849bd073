#include "map/check/map_check.hpp"

#include "common/geometry_box.hpp"
#include "common/phrases.hpp"
#include "map/check/map_check_geometry.hpp"
#include "map/check/map_check_mistakes.hpp"
#include "map/map_vocabulary.hpp"
#include "map/semantic_map_draft.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal {
namespace {

constexpr std::array<const char*, 4> kGeometryNames{"point", "corner", "segment", "circle"};

std::string rounded_metres(double length_m) { return fmt::format("{:.2f} m", length_m); }

/// "12 objects: 10 opal:Wall, 2 opal:Column".
std::string count_sentence(const std::string& what, const std::map<std::string, int>& counts, const char* unnamed) {
  std::size_t total = 0;
  std::string parts;
  for (const auto& [name, count] : counts) {
    total += count;
    parts += (parts.empty() ? ": " : ", ") + std::to_string(count) + " " + (name.empty() ? unnamed : name);
  }
  return count_of(total, what) + parts;
}

/// "'a', 'b', 'c' and 4 more": enough to find them, short enough to read.
std::string examples(const std::vector<std::string>& names) { return listed(names, "", 3); }

/// "2 storeys: low (12 features), top (3 features)".
std::string storeys_sentence(const std::map<std::string, int>& features_by_storey) {
  std::vector<std::string> parts;
  for (const auto& [storey, count] : features_by_storey)
    parts.push_back(storey + " (" + count_of(count, "feature") + ")");
  return count_of(parts.size(), "storey") + ": " + listed(parts);
}

void count_parts(const SemanticMap& map, MapCheck& check) {
  for (const MapObject& object : map.objects()) ++check.objects_by_type[object.type];
  for (const MapStorey& storey : map.origin().storeys) check.features_by_storey[storey.id] = 0;
  for (const MapConnection& connection : map.origin().connections) ++check.connections_by_type[connection.type];
  for (const MapPattern& pattern : map.patterns()) ++check.patterns_by_template[pattern.pattern_template];
  const std::string* previous_id = nullptr;
  for (const MapFeature& feature : map.features()) {
    ++check.features_by_type[feature.type];
    ++check.features_by_sensor[feature.sensor];
    if (previous_id && *previous_id == feature.id) continue;  // the same geometry, for another sensor
    previous_id = &feature.id;
    if (const MapStorey* storey = storey_at(map, anchor_of(feature.geometry))) ++check.features_by_storey[storey->id];
    ++check.features_by_geometry[feature.geometry.index()];
    if (const auto* segment = std::get_if<Segment>(&feature.geometry)) check.wall_length_m += segment->length_m();
  }
  check.shared_points = count_shared_points(map);
}

void measure_bounds(const SemanticMap& map, MapCheck& check) {
  Eigen::AlignedBox2d box;
  for (const MapFeature& feature : map.features()) box.extend(box_of(feature.geometry));
  if (!box.isEmpty()) check.bounds = {box.min(), box.max()};
}

void warn_about_geometry(const SemanticMap& map, MapCheck& check) {
  std::vector<std::string> names;
  for (const auto& [first, second] : duplicate_features(map))
    names.push_back(in_quotes(map.feature(first).id) + " and " + in_quotes(map.feature(second).id));
  if (!names.empty())
    check.warnings.push_back(count_of(names.size(), "feature") +
                             " with the geometry of another one: " + examples(names));
  names.clear();
  for (const PointPair& pair : unshared_points(map))
    names.push_back(in_quotes(pair.point) + " and " + in_quotes(pair.near_point));
  if (!names.empty())
    check.warnings.push_back(count_of(names.size(), "point") +
                             " within 1 cm of another point, without being one: " + examples(names));
  names.clear();
  if (map.features().size() > 1)
    for (const MapFeatureNumber number : isolated_features(map)) names.push_back(in_quotes(map.feature(number).id));
  if (!names.empty())
    check.warnings.push_back(count_of(names.size(), "feature") + " with no other within 15 m: " + examples(names));
}

/// Doors and windows are openings, leaves and panes: no feature, or one that no sensor perceives, is as it should be.
/// What an importer made of a source with classes is meant so, too: it reports what is hidden, and what is glass.
bool stands_in_the_way(const MapObject& object) {
  return object.type != "opal:Door" && object.type != "opal:Window" && object.notes.source_class.empty();
}

void warn_about_reach(const SemanticMap& map, MapCheck& check) {
  if (map.features().empty())
    check.warnings.push_back("no feature at all: nothing to localize by");
  else if (std::all_of(map.features().begin(), map.features().end(), [](const auto& f) { return f.sensor.empty(); }))
    check.warnings.push_back("no feature that a sensor perceives: nothing to localize by");
  std::vector<std::string> names;
  for (const MapObject& object : map.objects())
    if (object.features.empty() && stands_in_the_way(object)) names.push_back(in_quotes(object.id));
  if (!names.empty())
    check.warnings.push_back(count_of(names.size(), "object") + " that nothing represents: " + examples(names));
  names.clear();
  for (const MapFeature& feature : map.features())
    if (feature.sensor.empty() && stands_in_the_way(map.object(feature.object))) names.push_back(in_quotes(feature.id));
  if (!names.empty())
    check.warnings.push_back(count_of(names.size(), "feature") + " that no sensor perceives: " + examples(names));
}

void warn_about_unused(const SemanticMap& map, MapCheck& check) {
  std::map<std::string, std::vector<std::string>> nodes_by_word;
  for (const nlohmann::json& node : map.unused()) {
    const std::string id = in_quotes(vocabulary::compact_name(node.at("@id")));
    for (const auto& [key, value] : node.items()) {
      if (key == "@type")
        for (const nlohmann::json& type : value)
          nodes_by_word["type " + vocabulary::short_term(type.get_ref<const std::string&>())].push_back(id);
      else if (key != "@id")
        nodes_by_word["property " + vocabulary::short_term(key)].push_back(id);
    }
  }
  for (const auto& [word, ids] : nodes_by_word)
    check.warnings.push_back(word + " is kept, but not used, at " + count_of(ids.size(), "node") + ": " +
                             examples(ids));
}

}  // namespace

MapCheck check_map(const SemanticMap& map) {
  MapCheck check;
  count_parts(map, check);
  measure_bounds(map, check);
  warn_about_reach(map, check);
  warn_about_geometry(map, check);
  for (std::string& mistake : mistakes_of_hand(map)) check.warnings.push_back(std::move(mistake));
  warn_about_unused(map, check);
  return check;
}

std::vector<std::string> MapCheck::sentences() const {
  std::vector<std::string> lines{count_sentence("object", objects_by_type, ""),
                                 count_sentence("feature", features_by_type, "")};
  std::map<std::string, int> geometries;
  for (std::size_t kind = 0; kind < kGeometryNames.size(); ++kind)
    if (const int count = features_by_geometry[kind]; count > 0)
      geometries[std::string(kGeometryNames[kind]) + (count == 1 ? "" : "s")] = count;
  if (!geometries.empty()) {
    lines.push_back(count_sentence("geometric shape", geometries, "") + "; " + rounded_metres(wall_length_m) +
                    " of segments");
    lines.push_back(count_sentence("perceivable feature", features_by_sensor, "by no sensor"));
    lines.push_back(count_of(shared_points, "point") + " shared by several features");
    lines.push_back(std::string("from x ") + rounded_metres(bounds[0].x()) + ", y " + rounded_metres(bounds[0].y()) +
                    " to x " + rounded_metres(bounds[1].x()) + ", y " + rounded_metres(bounds[1].y()));
  }
  if (!features_by_storey.empty()) lines.push_back(storeys_sentence(features_by_storey));
  if (!connections_by_type.empty()) lines.push_back(count_sentence("connection", connections_by_type, ""));
  if (!patterns_by_template.empty()) lines.push_back(count_sentence("pattern", patterns_by_template, ""));
  for (const std::string& warning : warnings) lines.push_back(std::string("warning: ") + warning);
  if (warnings.empty()) lines.push_back("nothing to warn about");
  return lines;
}

}  // namespace opal
