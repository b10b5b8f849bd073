// JSON-LD 1.1 API, 6.1.2: Compaction. Numbers in comments are steps of that section.
#include "jsonld/compaction/compaction.hpp"

#include <algorithm>
#include <utility>

namespace opal::json_ld {
namespace {

const std::string kReverse = "@reverse";

bool is_scoped(const TermDefinition* definition) { return definition && definition->scoped; }

/// A context without the empty objects that it may be made of; null if nothing is left.
Json bare_context(const Json& context) {
  Json parts = Json::array();
  for (const Json& part : context.is_array() ? context : Json::array({context}))
    if (!part.is_object() || !part.empty()) parts.push_back(part);
  if (parts.empty()) return nullptr;
  return parts.size() == 1 ? parts[0] : parts;
}

}  // namespace

std::optional<std::string> text_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? std::optional(found->get<std::string>()) : std::nullopt;
}

bool is_graph_object(const Json& value) {
  if (!is_graph(value)) return false;
  for (const auto& [key, entry] : value.items())
    if (key != "@graph" && key != "@id" && key != "@index" && key != kPointer) return false;
  return true;
}

void add_compacted(Json& object, const std::string& key, Json value, bool as_array_wanted) {
  auto known = object.find(key);
  if (known == object.end()) {
    object[key] = as_array_wanted ? as_array(std::move(value)) : std::move(value);
    return;
  }
  if (!known->is_array()) *known = Json::array({std::move(*known)});
  append(*known, std::move(value));
}

Compactor::Compactor(const Options& options, const Json& context, const Place& place)
    : options_(options), contexts_(options), place_(place) {
  const bool wrapped = context.is_object() && context.contains("@context");
  const Json& local = wrapped ? context["@context"] : context;
  context_ = bare_context(local);
  ContextUse use;
  use.base = options.base;
  initial_ = contexts_.read(contexts_.initial(), local, place_, use);
}

Json Compactor::compact_document(const Json& expanded, bool always_graph) {
  Json compacted = compact(initial_, nullptr, expanded);
  if (!always_graph && compacted.is_array() && compacted.empty()) compacted = Json::object();
  if (always_graph) compacted = as_array(std::move(compacted));
  if (compacted.is_array()) compacted = Json{{alias(initial_, "@graph"), std::move(compacted)}};
  if (!context_.is_null()) compacted["@context"] = context_;
  return compacted;
}

Json Compactor::compact(const ContextPtr& active, Property property, const Json& element) {
  if (element.is_array()) return compact_array(active, property, element);
  if (element.is_object()) return compact_object(active, property, element);
  return element;
}

Json Compactor::compact_array(const ContextPtr& active, Property property, const Json& element) {  // 3
  Json result = Json::array();
  for (const Json& item : element)
    if (Json compacted = compact(active, property, item); !compacted.is_null()) result.push_back(std::move(compacted));
  const TermDefinition* definition = property ? active->find(*property) : nullptr;
  const bool keeps = property && (*property == "@graph" || *property == "@set");
  const bool held = definition && (definition->contains("@list") || definition->contains("@set"));
  if (result.size() != 1 || keeps || held || !options_.compact_arrays) return result;
  Json single = std::move(result[0]);
  return single;
}

Json Compactor::compact_object(ContextPtr active, Property property, const Json& element) {  // 5 to 12
  // The definition outlives the context that it comes from, which may be left in the next line.
  const ContextPtr outer = active;
  const TermDefinition* definition = property ? outer->find(*property) : nullptr;
  Object object;
  object.holder = definition;
  object.reversed = property && *property == kReverse;
  if (active->previous && !is_value(element) && !is_reference(element)) active = active->previous;
  if (is_scoped(definition)) active = contexts_.read_scoped(active, *definition, place_, false);
  object.type_scoped = active;
  if (is_value(element) || is_reference(element)) {
    Json value = compact_value(active, property ? active->find(*property) : nullptr, element);
    if (!value.is_object() || is_value(element) || (definition && definition->type == "@json")) return value;
  }
  if (is_list(element) && definition && definition->contains("@list"))
    return compact(active, property, element["@list"]);
  if (element.contains("@type")) active = take_type_contexts(active, element);
  for (const auto& [iri, value] : element.items()) compact_entry(object, active, iri, value);
  return std::move(object.result);
}

ContextPtr Compactor::take_type_contexts(const ContextPtr& active, const Json& element) {  // 11
  std::vector<std::string> types;
  for (const Json& type : element["@type"].is_array() ? element["@type"] : Json::array({element["@type"]}))
    if (type.is_string()) types.push_back(compact_iri(active, type.get<std::string>(), true));
  std::sort(types.begin(), types.end());
  ContextPtr result = active;
  for (const std::string& type : types) {
    const TermDefinition* definition = active->find(type);
    if (is_scoped(definition)) result = contexts_.read_scoped(result, *definition, place_, true);
  }
  return result;
}

void Compactor::compact_entry(Object& object, const ContextPtr& active, const std::string& iri, const Json& value) {
  Json& result = object.result;
  if (iri == "@id")
    result[alias(active, iri)] = value.is_string() ? Json(compact_iri(active, value.get<std::string>(), false)) : value;
  else if (iri == "@type")
    compact_types(object, active, value);
  else if (iri == kReverse)
    compact_reverse(object, active, value);
  else if (iri == "@index" && object.holder && object.holder->contains("@index"))
    return;
  else if (iri == "@index" || iri == "@value" || iri == "@language" || iri == "@direction")
    result[alias(active, iri)] = value;
  else if (iri != kPointer)
    compact_property(object, active, iri, value);
}

void Compactor::compact_types(Object& object, const ContextPtr& active, const Json& value) {  // 12.2
  const auto name = [&](const Json& type) -> Json {
    return type.is_string() ? Json(compact_iri(object.type_scoped, type.get<std::string>(), true)) : type;
  };
  Json names = Json::array();
  for (const Json& type : value.is_array() ? value : Json::array({value})) names.push_back(name(type));
  if (names.size() == 1) names = Json(std::move(names[0]));
  const std::string key = alias(active, "@type");
  const TermDefinition* definition = active->find(key);
  const bool as_set = definition && definition->contains("@set");
  add_compacted(object.result, key, std::move(names), as_set || !options_.compact_arrays);
}

void Compactor::compact_reverse(Object& object, const ContextPtr& active, const Json& value) {  // 12.3
  const Json compacted = compact(active, &kReverse, value);
  Json rest = Json::object();
  for (const auto& [key, nodes] : compacted.items()) {
    const TermDefinition* definition = active->find(key);
    if (definition && definition->reverse)
      add_compacted(object.result, key, nodes, definition->contains("@set") || !options_.compact_arrays);
    else
      rest[key] = nodes;
  }
  if (!rest.empty()) object.result[alias(active, kReverse)] = std::move(rest);
}

}  // namespace opal::json_ld
