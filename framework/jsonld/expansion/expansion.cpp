// JSON-LD 1.1 API, 5.1.2: Expansion. Numbers in comments are steps of that section.
#include "jsonld/expansion/expansion.hpp"

#include "jsonld/context/iri.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace opal::json_ld {
namespace {

bool is_top(const std::string* property) { return !property || *property == "@graph"; }

/// Whether the object has no entry but these; the kept pointer does not count.
bool has_only(const Json& object, std::initializer_list<std::string_view> keys) {
  return std::all_of(object.items().begin(), object.items().end(), [&](const auto& entry) {
    return entry.key() == kPointer || std::find(keys.begin(), keys.end(), entry.key()) != keys.end();
  });
}

/// Whether the key is the keyword or an alias of it.
bool means(const ActiveContext& active, const std::string& key, std::string_view keyword) {
  if (key == keyword) return true;
  const TermDefinition* definition = active.find(key);
  return definition && definition->iri == keyword;
}

}  // namespace

Json as_array(Json value) {
  if (value.is_array()) return value;
  Json array = Json::array();
  array.push_back(std::move(value));
  return array;
}

void append(Json& array, Json value) {
  if (!value.is_array()) return array.push_back(std::move(value));
  for (Json& element : value) array.push_back(std::move(element));
}

void add_value(Json& object, const std::string& key, Json value) {
  Json& values = object[key];
  if (values.is_null()) values = Json::array();
  append(values, std::move(value));
}

Json Expander::mark(Json object, const Place& place) const {
  if (options_.keep_pointers) object[kPointer] = place.pointer();
  return object;
}

Json Expander::expand_document(const Json& document) {
  Json expanded = expand(initial_context(), nullptr, document, Place());
  if (is_graph(expanded) && has_only(expanded, {"@graph"})) expanded = std::move(expanded["@graph"]);
  if (expanded.is_null()) return Json::array();
  return as_array(std::move(expanded));
}

ContextPtr Expander::initial_context() {
  const ContextPtr initial = contexts_.initial();
  const Json& given = options_.expand_context;
  if (given.is_null()) return initial;
  const bool wrapped = given.is_object() && given.contains("@context");
  ContextUse use;
  use.base = options_.base;
  return contexts_.read(initial, wrapped ? given["@context"] : given, Place("expand context#"), use);
}

Json Expander::expand(const ContextPtr& active, Property property, const Json& element, const Place& place,
                      bool from_map) {
  if (element.is_null()) return nullptr;
  if (element.is_array()) return expand_array(active, property, element, place, from_map);
  if (element.is_object()) return expand_object(active, property, element, place, from_map);
  return expand_scalar(active, property, element, place, property ? active->find(*property) : nullptr);
}

Json Expander::expand_scalar(const ContextPtr& active, Property property, const Json& element, const Place& place,
                             const TermDefinition* definition) {  // 4
  if (is_top(property)) {
    if (options_.reject_unknown_terms)
      throw JsonLdError("free-floating value", place.pointer(), "expected a node; JSON-LD drops other values here");
    return nullptr;
  }
  if (!definition || !definition->scoped) return expand_value(*active, definition, element, place);
  const ContextPtr scoped = contexts_.read_scoped(active, *definition, place, false);
  return expand_value(*scoped, scoped->find(*property), element, place);
}

Json Expander::expand_array(const ContextPtr& active, Property property, const Json& element, const Place& place,
                            bool from_map) {  // 5
  const TermDefinition* definition = property ? active->find(*property) : nullptr;
  const bool lists = definition && definition->contains("@list");
  Json result = Json::array();
  for (std::size_t i = 0; i < element.size(); ++i) {
    Json item = expand(active, property, element[i], place.at(i), from_map);
    if (lists && item.is_array()) item = Json{{"@list", std::move(item)}};
    if (!item.is_null()) append(result, std::move(item));
  }
  return result;
}

Json Expander::expand_object(ContextPtr active, Property property, const Json& element, const Place& place,
                             bool from_map) {  // 6 to 20
  // The definition outlives the context that it comes from, which may be left in the next line.
  const ContextPtr outer = active;
  const TermDefinition* definition = property ? outer->find(*property) : nullptr;
  if (active->previous && !from_map && !keeps_context(*active, element)) active = active->previous;  // 7
  if (definition && definition->scoped) active = contexts_.read_scoped(active, *definition, place, false);
  active = take_context(active, element, place);
  Object object;
  object.type_scoped = active;
  active = take_type_contexts(active, element, place);
  object.value_type = value_type(*active, element);
  expand_entries(object, active, property, element, place);
  return finish(std::move(object.result), property, place);
}

/// 7: value objects and references to a node stay in the context of the type around them.
bool Expander::keeps_context(const ActiveContext& active, const Json& element) const {
  for (const auto& [key, value] : element.items())
    if (means(active, key, "@value") || (element.size() == 1 && means(active, key, "@id"))) return true;
  return false;
}

ContextPtr Expander::take_context(const ContextPtr& active, const Json& element, const Place& place) {  // 9
  const auto local = element.find("@context");
  if (local == element.end()) return active;
  ContextUse use;
  use.base = options_.base;
  return contexts_.read(active, *local, place.at("@context"), use);
}

ContextPtr Expander::take_type_contexts(const ContextPtr& active, const Json& element,
                                        const Place& place) {  // 11
  ContextPtr result = active;
  for (const auto& [key, value] : element.items()) {
    if (!means(*active, key, "@type")) continue;
    std::vector<std::string> types;
    for (const Json& type : value.is_array() ? value : Json::array({value}))
      if (type.is_string()) types.push_back(type.get<std::string>());
    std::sort(types.begin(), types.end());
    for (const std::string& type : types) {
      const TermDefinition* definition = active->find(type);
      if (definition && definition->scoped) result = contexts_.read_scoped(result, *definition, place, true);
    }
  }
  return result;
}

/// 12: the last type of the first entry that means @type.
std::optional<std::string> Expander::value_type(const ActiveContext& active, const Json& element) const {
  for (const auto& [key, value] : element.items()) {
    if (!means(active, key, "@type")) continue;
    const Json& last = value.is_array() && !value.empty() ? value.back() : value;
    return last.is_string() ? expand_iri(active, last.get<std::string>(), {true, false}) : std::nullopt;
  }
  return {};
}

Json Expander::finish(Json result, Property property, const Place& place) const {  // 15 to 19
  if (result.contains("@value"))
    result = finish_value(std::move(result), place);
  else if (result.contains("@list") || result.contains("@set"))
    result = finish_container(std::move(result), place);
  else if (result.contains("@type"))
    result["@type"] = as_array(std::move(result["@type"]));
  if (!result.is_object()) return result;
  if (result.size() == 1 && result.contains("@language")) return nullptr;
  if (!framing_ && !result.contains("@value") && (result.contains("@language") || result.contains("@direction")))
    throw JsonLdError("invalid value object", place.pointer(), "expected @value beside @language or @direction");
  const bool floating = result.empty() || result.contains("@value") || result.contains("@list") ||
                        (!framing_ && result.size() == 1 && result.contains("@id"));
  if (is_top(property) && floating) return nullptr;
  return is_list(result) ? result : mark(std::move(result), place);
}

Json Expander::finish_value(Json result, const Place& place) const {  // 15
  const auto type = result.find("@type");
  const bool typed = type != result.end();
  if (!has_only(result, {"@direction", "@index", "@language", "@type", "@value"}) ||
      (typed && (result.contains("@language") || result.contains("@direction"))))
    throw JsonLdError("invalid value object", place.pointer(),
                      "expected beside @value only @type, or @language and @direction, and @index");
  if (framing_ || (typed && *type == "@json")) return result;
  const Json& value = result["@value"];
  if (value.is_null()) return nullptr;
  if (!value.is_string() && result.contains("@language"))
    throw JsonLdError("invalid language-tagged value", place.pointer(), "expected a string beside @language");
  if (typed && !(type->is_string() && is_absolute_iri(type->get<std::string>())))
    throw JsonLdError("invalid typed value", place.pointer(), "expected one @type that maps to an IRI");
  return result;
}

Json Expander::finish_container(Json result, const Place& place) const {  // 17
  const bool set = result.contains("@set");
  if (!has_only(result, {"@set", "@index"}) && !has_only(result, {"@list", "@index"}))
    throw JsonLdError("invalid set or list object", place.pointer(),
                      "expected beside @list or @set nothing but @index");
  return set ? std::move(result["@set"]) : std::move(result);
}

}  // namespace opal::json_ld
