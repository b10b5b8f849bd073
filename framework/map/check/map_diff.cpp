#include "map/check/map_diff.hpp"

#include "common/phrases.hpp"
#include "map/document/map_notes.hpp"
#include "map/document/storeys_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace opal {
namespace {

std::string metres(double length_m) {
  return length_m < 0.001 ? fmt::format("{:.3g} m", length_m) : fmt::format("{:.3f} m", length_m);
}

std::string number(double value) { return fmt::format("{:.9g}", value); }

std::string listed_or_none(const std::vector<std::string>& names) { return listed(names, "none"); }
std::string from_to(const std::string& before, const std::string& after) { return before + ", now " + after; }

std::vector<Point> points_in(const Geometry& geometry) {
  if (const auto* segment = std::get_if<Segment>(&geometry)) return {segment->begin, segment->end};
  return {anchor_of(geometry)};
}

const char* shape_of(const Geometry& geometry) {
  static constexpr const char* kNames[] = {"point", "corner", "segment", "circle"};
  return kNames[geometry.index()];
}

/// As a document has them.
template <class Noted>
nlohmann::ordered_json notes_of(const Noted& noted) {
  nlohmann::ordered_json notes = nlohmann::ordered_json::object();
  write_notes(noted, notes);
  if constexpr (std::is_same_v<Noted, MapOrigin>) {
    auto storeys = nlohmann::ordered_json::array();
    write_storeys(noted, storeys);
    for (const nlohmann::ordered_json& node : storeys)
      notes[std::string(node.at("@type")) + " " + std::string(node.at("@id"))] = node;
  }
  return notes;
}

std::string text_of(const nlohmann::ordered_json& notes, const std::string& key) {
  return notes.contains(key) ? notes[key].dump() : "not said";
}

/// Gathers changes of one thing after the other.
class MapComparison {
 public:
  MapComparison(const SemanticMap& before, const SemanticMap& after) : before_(before), after_(after) {}

  MapDiff run() {
    compare_maps();
    compare_all(MapPart::object, by_id(before_.objects()), by_id(after_.objects()));
    compare_all(MapPart::feature, by_id_and_sensor(before_), by_id_and_sensor(after_));
    compare_all(MapPart::pattern, by_id(before_.patterns()), by_id(after_.patterns()));
    return std::move(diff_);
  }

 private:
  template <class Part>
  using Named = std::vector<std::pair<std::pair<std::string, std::string>, const Part*>>;

  template <class Part>
  static Named<Part> by_id(const std::vector<Part>& parts) {
    Named<Part> named;
    for (const Part& part : parts) named.push_back({{part.id, ""}, &part});
    return named;
  }
  static Named<MapFeature> by_id_and_sensor(const SemanticMap& map) {
    Named<MapFeature> named;
    for (const MapFeature& feature : map.features()) named.push_back({{feature.id, feature.sensor}, &feature});
    return named;
  }

  void add(MapPart part, ChangeKind kind, const std::string& id, const std::string& detail, double moved_m = 0) {
    diff_.changes.push_back({part, kind, id, moved_m, detail});
  }
  /// Notes a value that differs.
  template <class Value, class Text>
  void compare(MapPart part, ChangeKind kind, const std::string& id, const std::string& what, const Value& before,
               const Value& after, Text text) {
    if (before != after) add(part, kind, id, (what.empty() ? "" : what + " ") + from_to(text(before), text(after)));
  }

  void compare_notes(MapPart part, const std::string& id, const nlohmann::ordered_json& before,
                     const nlohmann::ordered_json& after) {
    for (const auto& [key, value] : after.items())
      if (!before.contains(key) || before[key] != value)
        add(part, ChangeKind::altered, id, key + " " + from_to(text_of(before, key), value.dump()));
    for (const auto& [key, value] : before.items())
      if (!after.contains(key)) add(part, ChangeKind::altered, id, key + " " + from_to(value.dump(), "not said"));
  }

  void compare_maps() {
    compare(MapPart::map, ChangeKind::altered, "", "name", before_.name(), after_.name(), in_quotes);
    compare(MapPart::map, ChangeKind::altered, "", "smear_m", before_.origin().smear_m, after_.origin().smear_m,
            number);
    compare_notes(MapPart::map, "", notes_of(before_.origin()), notes_of(after_.origin()));
    if (before_.prefixes() != after_.prefixes()) add(MapPart::map, ChangeKind::altered, "", "other prefixes of names");
    if (before_.unused() != after_.unused())
      add(MapPart::map, ChangeKind::altered, "",
          "what other vocabularies say about " + std::to_string(before_.unused().size()) + " things, now about " +
              std::to_string(after_.unused().size()));
    compare_all(MapPart::map, by_id(before_.origin().placements), by_id(after_.origin().placements));
  }

  /// Both lists have each name once; changes come out in the order of the lists.
  template <class Part>
  void compare_all(MapPart kind, const Named<Part>& before, const Named<Part>& after) {
    using Name = std::pair<std::string, std::string>;
    std::map<Name, const Part*> rest(before.begin(), before.end());
    for (const auto& [name, part] : after) {
      const auto same = rest.find(name);
      if (same == rest.end()) {
        add(kind, ChangeKind::added, name.first, described(after_, *part));
      } else {
        compare_one(*same->second, *part);
        rest.erase(same);
      }
    }
    for (const auto& [name, part] : before)
      if (rest.count(name) > 0) add(kind, ChangeKind::removed, name.first, described(before_, *part));
  }

  static std::string described(const SemanticMap&, const MapObject& object) { return object.type; }
  static std::string described(const SemanticMap&, const MapPlacement&) { return "placement of a source"; }
  static std::string described(const SemanticMap&, const MapPattern& pattern) { return pattern.pattern_template; }
  static std::string described(const SemanticMap& map, const MapFeature& feature) {
    const std::string seen = feature.sensor.empty() ? "perceivable by none" : "perceivable by " + feature.sensor;
    return feature.type + " of " + map.object(feature.object).id + ", " + seen;
  }

  void compare_one(const MapObject& before, const MapObject& after) {
    compare(MapPart::object, ChangeKind::retyped, after.id, "", before.type, after.type, as_is);
    compare_notes(MapPart::object, after.id, notes_of(before.notes), notes_of(after.notes));
  }

  void compare_one(const MapPlacement& before, const MapPlacement& after) {
    const double moved_m = distance_m(before.T_map_source, after.T_map_source);
    if (moved_m > 0) add(MapPart::map, ChangeKind::moved, after.id, "placement", moved_m);
    compare(MapPart::map, ChangeKind::altered, after.id, "heading_rad", before.T_map_source.heading_rad(),
            after.T_map_source.heading_rad(), number);
    if (before.scale != after.scale) add(MapPart::map, ChangeKind::altered, after.id, "another scale");
  }

  void compare_one(const MapFeature& before, const MapFeature& after) {
    const std::string& id = after.id;
    const auto altered = [&](const std::string& what, const auto& old_value, const auto& new_value, auto text) {
      compare(MapPart::feature, ChangeKind::altered, id, what, old_value, new_value, text);
    };
    compare(MapPart::feature, ChangeKind::retyped, id, "", before.type, after.type, as_is);
    compare_geometries(id, before.geometry, after.geometry);
    altered("object", before_.object(before.object).id, after_.object(after.object).id, in_quotes);
    altered("position_sigma_m", before.position_sigma_m, after.position_sigma_m, number);
    altered("existence", before.existence, after.existence, number);
    altered("points", before.points, after.points, listed_or_none);
    altered("representation", before.representation, after.representation, in_quotes);
  }

  void compare_geometries(const std::string& id, const Geometry& before, const Geometry& after) {
    if (before.index() != after.index())
      return add(MapPart::feature, ChangeKind::altered, id, from_to(shape_of(before), shape_of(after)));
    const std::vector<Point> from = points_in(before), to = points_in(after);
    double moved_m = 0;
    for (std::size_t k = 0; k < from.size(); ++k) moved_m = std::max(moved_m, (to[k] - from[k]).norm());
    if (from != to) add(MapPart::feature, ChangeKind::moved, id, "", moved_m);
    const auto altered = [&](const char* what, double old_value, double new_value) {
      compare(MapPart::feature, ChangeKind::altered, id, what, old_value, new_value, number);
    };
    if (const auto* circle = std::get_if<Circle>(&before))
      altered("radius_m", circle->radius_m, std::get<Circle>(after).radius_m);
    if (const auto* corner = std::get_if<OrientedPoint>(&before)) {
      altered("heading_rad", corner->heading_rad, std::get<OrientedPoint>(after).heading_rad);
      altered("opening_rad", corner->opening_rad, std::get<OrientedPoint>(after).opening_rad);
    }
  }

  void compare_one(const MapPattern& before, const MapPattern& after) {
    const std::string& id = after.id;
    compare(MapPart::pattern, ChangeKind::retyped, id, "", before.pattern_template, after.pattern_template, as_is);
    compare(MapPart::pattern, ChangeKind::altered, id, "features", members(before_, before), members(after_, after),
            listed_or_none);
    compare(MapPart::pattern, ChangeKind::altered, id, "subpatterns", before.subpatterns, after.subpatterns,
            listed_or_none);
    compare(MapPart::pattern, ChangeKind::altered, id, "dimensions", numbers(before.dimensions),
            numbers(after.dimensions), listed_or_none);
  }

  static std::vector<std::string> members(const SemanticMap& map, const MapPattern& pattern) {
    std::vector<std::string> names;
    for (const MapFeatureNumber feature : pattern.features) {
      const MapFeature& member = map.feature(feature);
      names.push_back(member.id + (member.sensor.empty() ? "" : " for " + member.sensor));
    }
    return names;
  }

  static std::vector<std::string> numbers(const std::vector<double>& values) {
    std::vector<std::string> texts;
    for (const double value : values) texts.push_back(nlohmann::json(value).dump());
    return texts;
  }

  static std::string as_is(const std::string& text) { return text; }

  const SemanticMap& before_;
  const SemanticMap& after_;
  MapDiff diff_;
};

constexpr const char* kPartNames[] = {"map", "object", "feature", "pattern"};
constexpr const char* kChangeNames[] = {"added", "removed", "moved", "re-typed", "altered"};

/// "features: 2 added, 1 moved (by at most 0.120 m)"; empty if nothing changed.
std::string counts_of(const std::vector<MapChange>& changes, MapPart part) {
  int counts[5] = {};
  double farthest_m = 0;
  for (const MapChange& change : changes) {
    if (change.part != part) continue;
    ++counts[static_cast<int>(change.kind)];
    farthest_m = std::max(farthest_m, change.moved_m);
  }
  std::vector<std::string> texts;
  for (int kind = 0; kind < 5; ++kind) {
    if (counts[kind] == 0) continue;
    texts.push_back(std::to_string(counts[kind]) + " " + kChangeNames[kind]);
    if (kind == static_cast<int>(ChangeKind::moved)) texts.back() += " (by at most " + metres(farthest_m) + ")";
  }
  const std::string name = kPartNames[static_cast<int>(part)];
  return texts.empty() ? "" : name + (part == MapPart::map ? ": " : "s: ") + listed(texts);
}

std::string sentence_of(const MapChange& change) {
  std::string text = kPartNames[static_cast<int>(change.part)];
  if (!change.id.empty()) text += " " + change.id;
  text += std::string(" ") + kChangeNames[static_cast<int>(change.kind)];
  if (change.kind == ChangeKind::moved) text += " by " + metres(change.moved_m);
  return change.detail.empty() ? text : text + ": " + change.detail;
}

}  // namespace

std::vector<std::string> MapDiff::sentences() const {
  std::vector<std::string> all;
  for (const MapPart part : {MapPart::map, MapPart::object, MapPart::feature, MapPart::pattern})
    if (std::string counts = counts_of(changes, part); !counts.empty()) all.push_back(std::move(counts));
  for (const MapChange& change : changes) all.push_back(sentence_of(change));
  return all;
}

MapDiff map_diff(const SemanticMap& before, const SemanticMap& after) { return MapComparison(before, after).run(); }

}  // namespace opal
