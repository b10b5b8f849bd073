// What overlays change in a map.
#include "common/phrases.hpp"
#include "map/overlay/overlay_draft.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace opal {
namespace {

constexpr double kStale = 0.01;  // m, rad or probability: what differs more is not what the change was written for

[[noreturn]] void refuse(const OverlayChange& change, const std::string& message) {
  throw MapError(change.place + ": " + message);
}

bool is_coordinate(const std::string& word) { return word == "x" || word == "y"; }
bool is_quality(const std::string& word) { return word == "existence" || word == "position_sigma_m"; }

struct Range {
  double minimum, maximum;
  const char* expected;
};

Range range_of(const std::string& word) {
  if (word == "existence") return {0, 1, "a probability in [0, 1]"};
  if (word == "position_sigma_m") return {0, kFarthest_m, "metres >= 0"};
  if (word == "radius_m") return {1e-6, kFarthest_m, "metres > 0"};
  if (word == "opening_rad") return {1e-9, 2 * std::numbers::pi, "an angle in (0, 2 pi)"};
  return {-kFarthest_m, kFarthest_m,
          word == "heading_rad" ? "an angle" : "metres in the map frame, at most 1e6 from its origin"};
}

/// The number of a geometry that a word stands for; nullptr if it has no such number.
double* number_of(Geometry& geometry, const std::string& word) {
  if (auto* corner = std::get_if<OrientedPoint>(&geometry)) {
    if (word == "heading_rad") return &corner->heading_rad;
    if (word == "opening_rad") return &corner->opening_rad;
  }
  if (auto* circle = std::get_if<Circle>(&geometry); circle && word == "radius_m") return &circle->radius_m;
  return nullptr;
}

std::string short_text(double number) { return fmt::format("{:.6g}", number); }

std::string reason(const OverlayChange& change) { return change.because.empty() ? "" : ", because " + change.because; }

}  // namespace

/// What a change is about, in the draft; twins included.
struct ChangeMaker::Target {
  enum class Kind { object, features, point } kind = Kind::point;
  std::string id;
  MapObjectNumber object;
  std::vector<MapFeatureNumber> features;
  std::string point;  ///< that x and y are about; empty if there is none, or are several
};

bool ChangeMaker::find(const OverlayChange& change, Target& target) const {
  const auto is_in = [&](const auto& names) { return names.find(change.target) != names.end(); };
  target.id = change.target;
  if (is_in(draft_.objects_by_id)) {
    target.kind = Target::Kind::object;
    target.object = draft_.objects_by_id.at(change.target);
    if (const auto found = draft_.features_by_object.find(target.object); found != draft_.features_by_object.end())
      target.features = found->second;
    return true;
  }
  const bool representation = is_in(draft_.features_by_representation);
  if (is_in(draft_.features_by_id) || representation) {
    target.kind = Target::Kind::features;
    target.features = (representation ? draft_.features_by_representation : draft_.features_by_id).at(change.target);
    const MapFeature& first = draft_.feature(target.features.front());
    if (!representation && first.points.size() == 1) target.point = first.points.front();
    return true;
  }
  target.point = change.target;
  return is_in(draft_.features_by_point);
}

std::vector<double*> ChangeMaker::numbers_of(const Target& target, const std::string& word) const {
  std::vector<double*> numbers;
  if (is_coordinate(word)) {
    const auto places = draft_.features_by_point.find(target.point);
    if (places == draft_.features_by_point.end()) return {};
    for (const OverlayDraft::Place& place : places->second) {
      Point& point = *points_of(draft_.feature(place.feature).geometry)[place.point];
      numbers.push_back(word == "x" ? &point.x() : &point.y());
    }
    return numbers;
  }
  for (const MapFeatureNumber i : target.features) {
    MapFeature& feature = draft_.feature(i);
    double* number = word == "existence"          ? &feature.existence
                     : word == "position_sigma_m" ? &feature.position_sigma_m
                                                  : number_of(feature.geometry, word);
    if (!number) return {};
    numbers.push_back(number);
  }
  return numbers;
}

/// The change means something for its target, and no other change contradicts it.
void ChangeMaker::check(const OverlayChange& change, const Target& target) {
  for (const auto& [word, value] : change.numbers) {
    const Range range = range_of(word);
    if (!(value >= range.minimum && value <= range.maximum))
      refuse(change, word + " is " + text_of(value) + ", expected " + range.expected);
    if (numbers_of(target, word).empty() || (target.kind == Target::Kind::object && !is_quality(word)))
      refuse(change, "'" + target.id + "' has no " + word + ", expected " +
                         (is_coordinate(word) ? "a point, or a geometry that has just one"
                          : is_quality(word)  ? "an object that something represents, or a geometry"
                                              : "a geometry that has it"));
    if (is_coordinate(word)) claim("point '" + target.point + "' " + word, text_of(value), change.place);
    for (const MapFeatureNumber i : target.features)
      if (!is_coordinate(word)) claim("'" + draft_.feature(i).id + "' " + word, text_of(value), change.place);
    if (word == "heading_rad" || word == "opening_rad") set_corners.insert(target.id);
  }
  for (const auto& [word, type] : change.types) {
    const bool of_object = word == "object_type";
    if (of_object ? target.kind != Target::Kind::object : target.features.empty())
      refuse(change, "'" + target.id + "' has no " + word + ", expected " + (of_object ? "an object" : "a geometry"));
    if (of_object) claim("object '" + target.id + "' " + word, type, change.place);
    for (const MapFeatureNumber i : target.features)
      if (!of_object) claim("'" + draft_.feature(i).id + "' " + word, type, change.place);
  }
  for (const auto* sensors : {&change.perceivable_by, &change.not_perceivable_by})
    for (const std::string& sensor : *sensors) {
      if (target.features.empty())
        refuse(change,
               "'" + target.id +
                   "' is nothing that a sensor perceives, expected an object that something represents, or a geometry");
      for (const MapFeatureNumber i : target.features)
        claim("'" + draft_.feature(i).id + "' perceivable by " + sensor,
              sensors == &change.perceivable_by ? "yes" : "no", change.place);
    }
}

void ChangeMaker::claim(const std::string& what, const std::string& value, const std::string& place) {
  const auto [claim, is_new] = claims_.try_emplace(what, Claim{value, place});
  if (is_new || claim->second.value == value) return;
  const bool in_order = claim->second.place < place;  // the same message whatever the order of the overlays
  const Claim other{value, place};
  const Claim &first = in_order ? claim->second : other, &second = in_order ? other : claim->second;
  throw MapError(second.place + ": sets " + what + " to " + second.value + ", but " + first.place + " sets it to " +
                 first.value + "; expected one of them");
}

void ChangeMaker::check_was(const OverlayChange& change, const Target& target) {
  for (const auto& [word, was] : change.was) {
    const double now = *numbers_of(target, word).front(), wanted = change.numbers.at(word);
    if (std::abs(now - was) > kStale && std::abs(now - wanted) > kRounding_m)
      doubts.push_back(target.id + ": " + word + " is " + short_text(now) + " in the map, but was " + short_text(was) +
                       " when the change was written; set to " + short_text(wanted) + " (" + change.place + ")");
  }
}

std::string ChangeMaker::set_number(const Target& target, const std::string& word, double value) {
  const std::vector<double*> numbers = numbers_of(target, word);
  const double before = *numbers.front();
  bool changes = false;
  for (double* number : numbers) {
    changes = changes || *number != value;
    *number = value;
  }
  return changes ? word + " " + short_text(before) + " -> " + short_text(value) : "";
}

std::string ChangeMaker::set_type(const Target& target, const std::string& word, const std::string& type) {
  if (word == "object_type") {
    for (OverlayDraft::ObjectTwin& twin : draft_.object_twins)
      if (twin.object.id == target.id) twin.object.type = type;
    std::string& known = draft_.object(target.object).type;
    const std::string before = std::exchange(known, type);
    return before == type ? "" : word + " " + before + " -> " + type;
  }
  const std::string before = draft_.feature(target.features.front()).type;
  bool changes = false;
  for (const MapFeatureNumber i : target.features)
    changes = std::exchange(draft_.feature(i).type, type) != type || changes;
  return changes ? word + " " + before + " -> " + type : "";
}

std::string ChangeMaker::disable(const OverlayChange& change, const Target& target, const std::string& sensor) {
  std::size_t disabled = 0, others = 0, all = 0;
  for (const MapFeatureNumber i : target.features) {
    MapFeature& feature = draft_.feature(i);
    const bool counts = !draft_.is_twin(i);
    if (counts) ++all;
    if (counts && !feature.sensor.empty() && feature.sensor != sensor) ++others;
    if (feature.sensor != sensor) continue;
    feature.sensor.clear();
    if (counts) ++disabled;
  }
  if (disabled == 0 && others == all)
    doubts.push_back(target.id + ": is not perceivable by " + sensor + " but by " +
                     draft_.feature(target.features.front()).sensor + ", so that nothing is disabled (" + change.place +
                     ")");
  return disabled == 0 ? "" : count_of(disabled, "feature") + " no longer perceivable by " + sensor;
}

std::string ChangeMaker::enable(const Target& target, const std::string& sensor) {
  std::set<std::string> perceived;
  for (const MapFeatureNumber i : target.features)
    if (draft_.feature(i).sensor == sensor && !draft_.is_twin(i)) perceived.insert(draft_.feature(i).id);
  std::size_t enabled = 0;
  for (const MapFeatureNumber i : target.features) {
    if (draft_.is_twin(i)) {
      if (draft_.feature(i).sensor.empty()) draft_.feature(i).sensor = sensor;
      continue;
    }
    if (!perceived.insert(draft_.feature(i).id).second) continue;
    ++enabled;
    if (draft_.feature(i).sensor.empty()) {
      draft_.feature(i).sensor = sensor;
      continue;
    }
    MapFeature for_sensor = draft_.feature(i);
    for_sensor.sensor = sensor;
    for_sensor.representation.clear();
    draft_.add(std::move(for_sensor));
  }
  return enabled == 0 ? "" : count_of(enabled, "feature") + " perceivable by " + sensor;
}

/// In three rounds, so that the order of changes means nothing: a feature for another sensor is a copy of what the
/// first round left.
void ChangeMaker::apply(const Found& found) {
  std::vector<std::vector<std::string>> effects(found.size());
  const auto round = [&](auto step) {
    for (std::size_t i = 0; i < found.size(); ++i) step(*found[i].first, found[i].second, effects[i]);
  };
  using Texts = std::vector<std::string>;
  round([&](const OverlayChange& change, const Target& target, Texts& texts) {
    for (const auto& [word, value] : change.numbers) texts.push_back(set_number(target, word, value));
    for (const auto& [word, type] : change.types) texts.push_back(set_type(target, word, type));
  });
  round([&](const OverlayChange& change, const Target& target, Texts& texts) {
    for (const std::string& sensor : change.not_perceivable_by) texts.push_back(disable(change, target, sensor));
  });
  round([&](const OverlayChange& change, const Target& target, Texts& texts) {
    for (const std::string& sensor : change.perceivable_by) texts.push_back(enable(target, sensor));
  });
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::string text;
    for (const std::string& effect : effects[i])
      if (!effect.empty()) text += (text.empty() ? "" : "; ") + effect;
    sentences.push_back(found[i].second.id + ": " + (text.empty() ? "as wanted already" : text) +
                        reason(*found[i].first));
  }
}

void ChangeMaker::make(const std::vector<MapOverlay>& overlays) {
  Found found;
  std::string missing;
  for (const MapOverlay& overlay : overlays)
    for (const OverlayChange& change : overlay.changes) {
      Target target;
      if (find(change, target)) {
        check(change, target);
        found.emplace_back(&change, std::move(target));
      } else if (options_.report_missing || change.report_if_missing) {
        doubts.push_back(change.target + ": the map does not have it, so nothing is changed (" + change.place + ")" +
                         reason(change));
      } else {
        missing += "\n  " + change.place + ": '" + change.target + "'" + reason(change);
      }
    }
  if (!missing.empty())
    throw MapError(
        "the map does not have what is to be changed; expected ids of the map, or \"if_missing\": \"report\":" +
        missing);
  for (const auto& [change, target] : found) check_was(*change, target);
  apply(found);
}

}  // namespace opal
