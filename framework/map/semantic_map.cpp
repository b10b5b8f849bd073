#include "map/semantic_map_draft.hpp"

#include "map/map_vocabulary.hpp"
#include "map/semantic_map_storeys.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <unordered_map>

namespace opal {
namespace {

template <class Element>
std::vector<std::string> places_in(const std::string& list, const std::vector<Element>& elements) {
  std::vector<std::string> places;
  for (std::size_t i = 0; i < elements.size(); ++i)
    places.push_back(list + "/" + std::to_string(i) + " '" + elements[i].id + "'");
  return places;
}

bool is_word(const std::string& text) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.'; };
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 && std::ranges::all_of(text, fits);
}

/// A type's name with its prefix, which gets an IRI if it has none.
std::string type_name(MapDraft& draft, const std::string& place, const std::string& type) {
  const std::string name = vocabulary::compact_name(vocabulary::full_iri(type), draft.prefixes);
  const std::string prefix = vocabulary::prefix_of(name);
  const bool has_colon = name.find(':') != std::string::npos,
             blank = name.find_first_of(" \t\r\n") != std::string::npos;
  if (!has_colon || blank || vocabulary::is_term(prefix) || (!prefix.empty() && !is_word(prefix)))
    draft.fail(place, "type '" + type + "', expected a term of " + vocabulary::kContextIri +
                          " or a name with a prefix, such as opal:Wall");
  if (!prefix.empty() && !vocabulary::is_prefix(prefix))
    draft.prefixes.try_emplace(prefix, vocabulary::iri_of_nameless_prefix(prefix));
  return name;
}

std::vector<std::string> point_names(const MapFeature& feature) {
  if (kind_of(feature.geometry) == GeometryKind::point) return {feature.id};
  std::vector<std::string> names;
  for (const char* role : point_roles(feature.geometry)) names.push_back(feature.id + "/" + role);
  return names;
}

/// Names of types, of which a map has few.
class TypeNames {
 public:
  explicit TypeNames(MapDraft& draft) : draft_(draft) {}
  /// @return whether the type is new.
  bool name(std::string& type, const std::string& place) {
    const auto [entry, is_new] = names_.try_emplace(type);
    if (is_new) entry->second = type_name(draft_, place, type);
    type = entry->second;
    return is_new;
  }

 private:
  MapDraft& draft_;
  std::unordered_map<std::string, std::string> names_;  ///< by how they are written
};

void name_types(MapDraft& draft) {
  TypeNames of_objects(draft), of_features(draft), of_patterns(draft);
  for (std::size_t i = 0; i < draft.objects.size(); ++i) {
    std::string& type = draft.objects[i].type;
    const bool is_new = of_objects.name(type, draft.object_places[i]);
    if (is_new && vocabulary::is_reserved_type(vocabulary::full_iri(type)))
      draft.fail(draft.object_places[i], "object of type " + type + ", expected the type of a thing in a building");
  }
  for (std::size_t i = 0; i < draft.features.size(); ++i) {
    MapFeature& feature = draft.features[i];
    if (feature.type.empty()) feature.type = vocabulary::default_feature_type(feature.geometry);
    of_features.name(feature.type, draft.feature_places[i]);
  }
  for (std::size_t i = 0; i < draft.patterns.size(); ++i) {
    of_patterns.name(draft.patterns[i].pattern_template, draft.pattern_places[i]);
  }
}

/// Ids may be written in full or with a prefix; in memory they have the prefix.
void name_ids(MapDraft& draft) {
  const auto compact = [&draft](std::string& name) { name = vocabulary::compact_name(name, draft.prefixes); };
  for (MapObject& object : draft.objects) compact(object.id);
  for (MapFeature& feature : draft.features) {
    for (std::string* name : {&feature.id, &feature.sensor, &feature.representation}) compact(*name);
    for (std::string& point : feature.points) compact(point);
    if (feature.points.empty()) feature.points = point_names(feature);
  }
  for (MapPattern& pattern : draft.patterns) {
    compact(pattern.id);
    for (std::string& part : pattern.subpatterns) compact(part);
  }
  for (MapPlacement& placement : draft.origin.placements) compact(placement.id);
  name_storeys(draft);
}

/// Sorts elements and their places alike. @return for each old number the new one.
template <class Element, class Before>
std::vector<Id<Element>> sort_elements(std::vector<Element>& elements, std::vector<std::string>& places,
                                       Before before) {
  std::vector<Id<Element>> new_number(elements.size());
  if (std::ranges::is_sorted(elements, before)) {  // as `opal map` writes them
    for (std::size_t k = 0; k < elements.size(); ++k) new_number[k] = Id<Element>(k);
    return new_number;
  }
  std::vector<int> order(elements.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](int a, int b) { return before(elements[a], elements[b]); });
  std::vector<Element> sorted;
  std::vector<std::string> sorted_places;
  sorted.reserve(elements.size());
  sorted_places.reserve(places.size());
  for (const int old_position : order) {
    new_number[old_position] = Id<Element>(sorted.size());
    sorted.push_back(std::move(elements[old_position]));
    sorted_places.push_back(std::move(places[old_position]));
  }
  elements = std::move(sorted);
  places = std::move(sorted_places);
  return new_number;
}

/// Feature numbers per object, from the features' side.
void list_features(MapDraft& draft) {
  for (MapObject& object : draft.objects) object.features.clear();
  for (std::size_t i = 0; i < draft.features.size(); ++i)
    draft.objects[draft.features[i].object.number()].features.emplace_back(i);
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// The number that begins at a place, without leading zeros; leads behind it.
std::string_view number_at(const std::string& text, std::size_t& at) {
  while (at < text.size() && text[at] == '0') ++at;
  const std::size_t begin = at;
  while (at < text.size() && is_digit(text[at])) ++at;
  return std::string_view(text).substr(begin, at - begin);
}

}  // namespace

void MapDraft::fail(const std::string& place, const std::string& message) const {
  throw MapError(source + ": " + place + ": " + message);
}

bool id_before(const std::string& a, const std::string& b) {
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (is_digit(a[i]) && is_digit(b[k])) {
      const std::string_view number_a = number_at(a, i), number_b = number_at(b, k);
      if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
      if (number_a != number_b) return number_a < number_b;
    } else if (a[i] != b[k]) {
      return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[k]);
    } else {
      ++i, ++k;
    }
  }
  const bool a_ends = i == a.size(), b_ends = k == b.size();
  return a_ends == b_ends ? a < b : a_ends;  // "w01" and "w1" differ by their zeros only
}

void add_unused(nlohmann::json& unused, const nlohmann::json& more) {
  for (const nlohmann::json& node : more) {
    const auto known =
        std::ranges::find_if(unused, [&](const nlohmann::json& one) { return one["@id"] == node["@id"]; });
    if (known == unused.end()) {
      unused.push_back(node);
      continue;
    }
    for (const auto& [key, values] : node.items()) {
      nlohmann::json& said = (*known)[key];
      if (!said.is_array()) said = values;
      for (const nlohmann::json& value : values.is_array() ? values : nlohmann::json::array())
        if (std::ranges::find(said, value) == said.end()) said.push_back(value);
      if (said.is_array()) std::sort(said.begin(), said.end());
    }
  }
  std::sort(unused.begin(), unused.end(),
            [](const nlohmann::json& a, const nlohmann::json& b) { return a["@id"] < b["@id"]; });
}

void name_everything(MapDraft& draft) {
  name_types(draft);
  name_ids(draft);
}

void sort_by_id(MapDraft& draft) {
  const auto by_id = [](const auto& a, const auto& b) { return id_before(a.id, b.id); };
  const std::vector<MapObjectNumber> objects = sort_elements(draft.objects, draft.object_places, by_id);
  const std::vector<MapFeatureNumber> features =
      sort_elements(draft.features, draft.feature_places, [](const MapFeature& a, const MapFeature& b) {
        return a.id == b.id ? id_before(a.sensor, b.sensor) : id_before(a.id, b.id);
      });
  sort_elements(draft.patterns, draft.pattern_places, by_id);
  std::ranges::stable_sort(draft.origin.placements, by_id);
  sort_storeys(draft.origin);
  for (MapFeature& feature : draft.features) feature.object = objects[feature.object.number()];
  for (MapPattern& pattern : draft.patterns)
    for (MapFeatureNumber& feature : pattern.features) feature = features[feature.number()];
  list_features(draft);
}

SemanticMap::SemanticMap(MapDraft&& checked)
    : name_(std::move(checked.name)),
      objects_(std::move(checked.objects)),
      features_(std::move(checked.features)),
      patterns_(std::move(checked.patterns)),
      origin_(std::move(checked.origin)),
      prefixes_(std::move(checked.prefixes)),
      unused_(std::move(checked.unused)) {}

std::shared_ptr<const SemanticMap> SemanticMap::finish(MapDraft draft) {
  check_references(draft);
  name_everything(draft);
  sort_by_id(draft);
  check_ids(draft);
  unify_shared_points(draft);
  check_values(draft);
  check_storeys(draft);
  for (std::size_t i = 0; i < draft.patterns.size(); ++i)
    draft.patterns[i].place = draft.source + ": " + draft.pattern_places[i];
  return std::shared_ptr<const SemanticMap>(new SemanticMap(std::move(draft)));
}

std::shared_ptr<const SemanticMap> SemanticMap::make(std::string name, std::vector<MapObject> objects,
                                                     std::vector<MapFeature> features, std::vector<MapPattern> patterns,
                                                     MapOrigin origin) {
  MapDraft draft{
      name, std::move(name), std::move(objects), std::move(features), std::move(patterns), std::move(origin)};
  draft.object_places = places_in("/objects", draft.objects);
  draft.feature_places = places_in("/features", draft.features);
  draft.pattern_places = places_in("/patterns", draft.patterns);
  return finish(std::move(draft));
}

std::shared_ptr<const SemanticMap> SemanticMap::with_patterns(std::vector<MapPattern> patterns) const {
  return with_contents(objects_, features_, std::move(patterns));
}

std::shared_ptr<const SemanticMap> SemanticMap::with_contents(std::vector<MapObject> objects,
                                                              std::vector<MapFeature> features,
                                                              std::vector<MapPattern> patterns,
                                                              const std::map<std::string, std::string>& more_prefixes,
                                                              const nlohmann::json& more_unused) const {
  MapDraft draft{name_,     name_,  std::move(objects), std::move(features), std::move(patterns), origin_,
                 prefixes_, unused_};
  draft.prefixes.insert(more_prefixes.begin(), more_prefixes.end());
  add_unused(draft.unused, more_unused);
  draft.object_places = places_in("/objects", draft.objects);
  draft.feature_places = places_in("/features", draft.features);
  draft.pattern_places = places_in("/patterns", draft.patterns);
  return finish(std::move(draft));
}

}  // namespace opal
