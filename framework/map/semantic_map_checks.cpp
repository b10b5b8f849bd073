#include "map/semantic_map_draft.hpp"

#include "map/claimed_names.hpp"
#include "map/map_vocabulary.hpp"

#include <cmath>
#include <numbers>
#include <string_view>
#include <unordered_map>

namespace opal {
namespace {

using vocabulary::default_feature_type;

// ---------------------------------------------------------------- references

void check_listed_features(const MapDraft& draft, std::size_t object) {
  for (const MapFeatureNumber number : draft.objects[object].features)
    if (!draft.has(number) || draft.feature(number).object != MapObjectNumber(object))
      draft.fail(draft.object_places[object], "lists feature number " + to_string(number) +
                                                  ", which does not name this object; leave the list empty");
}

void check_point_names(const MapDraft& draft, std::size_t i) {
  const MapFeature& feature = draft.features[i];
  const std::size_t expected = point_roles(feature.geometry).size();
  if (!feature.points.empty() && feature.points.size() != expected)
    draft.fail(draft.feature_places[i], "names " + std::to_string(feature.points.size()) + " points, expected " +
                                            std::to_string(expected) + ", or none");
  const bool own_point = kind_of(feature.geometry) == GeometryKind::point && !feature.points.empty();
  if (own_point && feature.points[0] != feature.id)
    draft.fail(draft.feature_places[i],
               "point '" + feature.points[0] + "', expected the feature's own id for a point feature");
}

// ---------------------------------------------------------------- ids

/// Length in bytes of the UTF-8 character at `text[i]` (RFC 3629, section 4); 0 if there is none.
std::size_t utf8_length(const std::string& text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
  const unsigned first = byte(i), second = byte(i + 1);
  const auto tail = [&](std::size_t k) { return (byte(k) & 0xC0) == 0x80; };
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4 || !tail(i + 1)) return 0;
  if (first < 0xE0) return 2;
  if (first < 0xF0) {
    const bool overlong = first == 0xE0 && second < 0xA0, surrogate = first == 0xED && second > 0x9F;
    return overlong || surrogate || !tail(i + 2) ? 0 : 3;
  }
  const bool overlong = first == 0xF0 && second < 0x90, beyond = first == 0xF4 && second > 0x8F;
  return overlong || beyond || !tail(i + 2) || !tail(i + 3) ? 0 : 4;
}

/// The text can be written as JSON, which is UTF-8. @throws MapError.
void check_text(const MapDraft& draft, const std::string& place, const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) draft.fail(place, "a name holds bytes that are not UTF-8");
    i += length;
  }
}

void claim_feature(const MapDraft& draft, std::size_t i, ClaimedNames& names) {
  const MapFeature& feature = draft.features[i];
  const std::string& place = draft.feature_places[i];
  const bool is_point = kind_of(feature.geometry) == GeometryKind::point;
  names.claim(feature.id, is_point ? "point" : "feature", place);
  for (const std::string& point : feature.points) names.claim(point, "point", place);
  if (!feature.sensor.empty()) names.claim(feature.sensor, "sensor", place);
  if (!feature.representation.empty()) names.claim(feature.representation, "representation", place);
  for (const std::string* text : {&feature.id, &feature.type, &feature.sensor, &feature.representation})
    check_text(draft, place, *text);
  for (const std::string& point : feature.points) check_text(draft, place, point);
}

bool same_geometry(const Geometry& a, const Geometry& b) {
  if (a.index() != b.index() || points_of(a) != points_of(b)) return false;
  if (const auto* corner = std::get_if<OrientedPoint>(&a))
    return corner->heading_rad == std::get<OrientedPoint>(b).heading_rad &&
           corner->opening_rad == std::get<OrientedPoint>(b).opening_rad;
  if (const auto* circle = std::get_if<Circle>(&a)) return circle->radius_m == std::get<Circle>(b).radius_m;
  return true;
}

/// One geometry seen by several sensors: all that it says about the building is the same.
void check_same_id(const MapDraft& draft, std::size_t i) {
  const MapFeature& a = draft.features[i - 1];
  const MapFeature& b = draft.features[i];
  const std::string& place = draft.feature_places[i];
  if (a.object != b.object)
    draft.fail(place, "feature '" + a.id + "' belongs to '" + draft.object(a.object).id + "' and to '" +
                          draft.object(b.object).id + "', expected one object");
  if (a.sensor == b.sensor)
    draft.fail(place, "two features have the id '" + a.id + "' and the sensor '" + a.sensor +
                          "', expected an id of its own for each geometry");
  if (!same_geometry(a.geometry, b.geometry) || a.points != b.points || a.position_sigma_m != b.position_sigma_m ||
      a.existence != b.existence)
    draft.fail(place, "feature '" + a.id + "' has different geometry, position_sigma_m or existence for '" + a.sensor +
                          "' and '" + b.sensor + "', expected the same, or another id");
}

std::string explicit_type(const MapFeature& feature) {
  return feature.type == default_feature_type(feature.geometry) ? "" : feature.type;
}

void check_representations(const MapDraft& draft) {
  std::unordered_map<std::string_view, std::size_t> first_use;
  for (std::size_t i = 0; i < draft.features.size(); ++i) {
    const MapFeature& feature = draft.features[i];
    if (feature.representation.empty()) continue;
    const MapFeature& first = draft.features[first_use.try_emplace(feature.representation, i).first->second];
    if (first.object != feature.object || first.sensor != feature.sensor ||
        explicit_type(first) != explicit_type(feature))
      draft.fail(draft.feature_places[i], "features '" + first.id + "' and '" + feature.id +
                                              "' share the representation '" + feature.representation +
                                              "', but not object, sensor and feature type");
  }
}

// ---------------------------------------------------------------- values

void check_range(const MapDraft& draft, const std::string& place, const char* what, double value, bool good,
                 const char* expected) {
  if (!good || !std::isfinite(value))
    draft.fail(place, std::string(what) + " " + text_of(value) + ", expected " + expected);
}

void check_geometry(const MapDraft& draft, const std::string& place, const Geometry& geometry) {
  const std::vector<const char*> roles = point_roles(geometry);
  const std::vector<Point> points = points_of(geometry);
  for (std::size_t k = 0; k < points.size(); ++k)
    for (const double coordinate : {points[k].x(), points[k].y()})
      check_range(draft, place, (std::string("coordinate of ") + roles[k]).c_str(), coordinate,
                  std::abs(coordinate) <= kFarthest_m, "metres in the map frame, at most 1e6 from its origin");
  if (const auto* segment = std::get_if<Segment>(&geometry))
    check_range(draft, place, "length of the segment", segment->length_m(), segment->length_m() > kRounding_m,
                "two different points");
  if (const auto* circle = std::get_if<Circle>(&geometry))
    check_range(draft, place, "radius_m", circle->radius_m, circle->radius_m > 0 && circle->radius_m <= kFarthest_m,
                "a positive number of metres up to 1e6");
  if (const auto* corner = std::get_if<OrientedPoint>(&geometry)) {
    check_range(draft, place, "heading_rad", corner->heading_rad, true, "a finite angle");
    check_range(draft, place, "opening_rad", corner->opening_rad,
                corner->opening_rad > 0 && corner->opening_rad < 2 * std::numbers::pi, "an angle in (0, 2 pi)");
  }
}

void check_pattern(const MapDraft& draft, std::size_t i) {
  const MapPattern& pattern = draft.patterns[i];
  const std::string& place = draft.pattern_places[i];
  if (pattern.features.empty()) draft.fail(place, "pattern '" + pattern.id + "' has no features, expected its members");
  const std::string& sensor = draft.feature(pattern.features.front()).sensor;
  for (const MapFeatureNumber member : pattern.features)
    if (draft.feature(member).sensor != sensor)
      draft.fail(place, "members '" + draft.feature(pattern.features.front()).id + "' and '" +
                            draft.feature(member).id + "' are perceivable by '" + sensor + "' and '" +
                            draft.feature(member).sensor + "', expected one sensor");
  for (const double dimension : pattern.dimensions)
    check_range(draft, place, "dimension", dimension, true, "a finite number");
}

void check_origin(const MapDraft& draft) {
  check_range(draft, "map", "smear_m", draft.origin.smear_m, draft.origin.smear_m >= 0 && draft.origin.smear_m <= 10,
              "metres in [0, 10]");
  for (const MapPlacement& placement : draft.origin.placements) {
    const std::string place = "placement '" + placement.id + "'";
    for (const double value : {placement.T_map_source.x(), placement.T_map_source.y()})
      check_range(draft, place, "coordinate", value, std::abs(value) <= kFarthest_m,
                  "metres in the map frame, at most 1e6 from its origin");
    check_range(draft, place, "heading_rad", placement.T_map_source.heading_rad(), true, "a finite angle");
    for (const double value : {placement.scale.x(), placement.scale.y()})
      check_range(draft, place, "scale", value, std::abs(value) >= 1e-3 && std::abs(value) <= 1e3,
                  "a factor of 0.001 to 1000, below zero if mirrored");
  }
}

/// Depth-first search for a pattern that is part of itself, without recursion: chains may be long.
void check_pattern_cycles(const MapDraft& draft) {
  std::unordered_map<std::string, std::size_t> position;
  for (std::size_t i = 0; i < draft.patterns.size(); ++i) position[draft.patterns[i].id] = i;
  enum class State { unseen, open, done };
  std::vector<State> states(draft.patterns.size(), State::unseen);
  for (std::size_t root = 0; root < states.size(); ++root) {
    std::vector<std::size_t> stack{root};
    while (!stack.empty()) {
      const std::size_t here = stack.back();
      if (states[here] != State::unseen) {
        states[here] = State::done;
        stack.pop_back();
        continue;
      }
      states[here] = State::open;
      for (const std::string& part : draft.patterns[here].subpatterns) {
        const auto found = position.find(part);
        if (found == position.end())
          draft.fail(draft.pattern_places[here], "subpattern '" + part + "', expected the id of a pattern of this map");
        if (states[found->second] == State::open)
          draft.fail(draft.pattern_places[here], "subpattern '" + part + "' contains this pattern, expected no cycle");
        if (states[found->second] == State::unseen) stack.push_back(found->second);
      }
    }
  }
}

}  // namespace

void check_references(const MapDraft& draft) {
  for (std::size_t i = 0; i < draft.features.size(); ++i) {
    if (!draft.has(draft.features[i].object))
      draft.fail(draft.feature_places[i], "object number " + to_string(draft.features[i].object) +
                                              ", expected one of " + std::to_string(draft.objects.size()) + " objects");
    check_point_names(draft, i);
  }
  for (std::size_t i = 0; i < draft.objects.size(); ++i) check_listed_features(draft, i);
  for (std::size_t i = 0; i < draft.patterns.size(); ++i)
    for (const MapFeatureNumber member : draft.patterns[i].features)
      if (!draft.has(member))
        draft.fail(draft.pattern_places[i], "feature number " + to_string(member) + ", expected one of " +
                                                std::to_string(draft.features.size()) + " features");
}

void check_ids(const MapDraft& draft) {
  ClaimedNames names(draft);
  check_text(draft, "name", draft.name);
  const auto claim = [&](const std::string& id, const char* what, const std::string& place, const std::string& more) {
    names.claim_alone(id, what, place);
    check_text(draft, place, id + more);
  };
  for (std::size_t i = 0; i < draft.objects.size(); ++i)
    claim(draft.objects[i].id, "object", draft.object_places[i], draft.objects[i].type);
  for (std::size_t i = 0; i < draft.features.size(); ++i) {
    claim_feature(draft, i, names);
    if (i > 0 && draft.features[i].id == draft.features[i - 1].id) check_same_id(draft, i);
  }
  for (std::size_t i = 0; i < draft.patterns.size(); ++i)
    claim(draft.patterns[i].id, "pattern", draft.pattern_places[i], draft.patterns[i].pattern_template);
  const auto claim_all = [&](const auto& things, const char* what) {
    for (const auto& thing : things) claim(thing.id, what, what + (" '" + thing.id + "'"), "");
  };
  claim_all(draft.origin.placements, "placement");
  claim_all(draft.origin.buildings, "building");
  claim_all(draft.origin.storeys, "storey");
  claim_all(draft.origin.connections, "connection");
  check_representations(draft);
}

void check_values(const MapDraft& draft) {
  check_origin(draft);
  for (std::size_t i = 0; i < draft.features.size(); ++i) {
    const MapFeature& feature = draft.features[i];
    const std::string& place = draft.feature_places[i];
    check_geometry(draft, place, feature.geometry);
    check_range(draft, place, "position_sigma_m", feature.position_sigma_m,
                feature.position_sigma_m >= 0 && feature.position_sigma_m <= kFarthest_m, "metres >= 0");
    check_range(draft, place, "existence", feature.existence, feature.existence >= 0 && feature.existence <= 1,
                "a probability in [0, 1]");
  }
  for (std::size_t i = 0; i < draft.patterns.size(); ++i) check_pattern(draft, i);
  check_pattern_cycles(draft);
}

}  // namespace opal
