// JSON-LD 1.1 API, 6.1.2, steps 12.7 and 12.8: the values of a property, and the containers that they stand in.
#include "jsonld/compaction/compaction.hpp"

#include <utility>

namespace opal::json_ld {
namespace {

const std::string kList = "@list";
const std::string kGraph = "@graph";

/// An array with one value is that value.
Json unwrapped(Json value) {
  if (!value.is_array() || value.size() != 1) return value;
  Json single = std::move(value[0]);
  return single;
}

/// Takes the first string of an entry, which keeps the others. @return null if there is none.
Json take_first(Json& object, const std::string& key) {
  if (!object.is_object() || !object.contains(key)) return nullptr;
  Json values = as_array(std::move(object[key]));
  object.erase(key);
  Json first;
  if (!values.empty() && values[0].is_string()) {
    first = values[0];
    values.erase(values.begin());
  }
  if (!values.empty()) object[key] = unwrapped(std::move(values));
  return first;
}

}  // namespace

void Compactor::compact_property(Object& object, const ContextPtr& active, const std::string& iri, const Json& values) {
  const bool reverse = object.reversed;
  if (!values.is_array()) {  // of keywords that only framing knows
    object.result[alias(active, iri)] = values;
    return;
  }
  if (values.empty()) {  // 12.7
    const std::string key = compact_iri(active, iri, true, &values, reverse);
    add_compacted(nest_of(object.result, *active, active->find(key)), key, values, true);
  }
  for (const Json& value : values) {  // 12.8
    const std::string key = compact_iri(active, iri, true, &value, reverse);
    const TermDefinition* definition = active->find(key);
    Json& nest = nest_of(object.result, *active, definition);
    const Json& inner = is_list(value) ? value[kList] : is_graph_object(value) ? value[kGraph] : value;
    const bool set = definition && definition->contains("@set");
    const bool as_array = set || iri == kGraph || iri == kList || !options_.compact_arrays;
    Item item{value, compact(active, &key, inner), key, definition, as_array};
    if (is_list(value))
      add_list(nest, active, std::move(item));
    else if (is_graph_object(value))
      add_graph(nest, active, std::move(item));
    else if (item.in("@language") || item.in("@index") || item.in("@id") || item.in("@type"))
      add_to_map(nest, active, std::move(item));
    else
      add_compacted(nest, key, std::move(item.compacted), as_array);
  }
}

/// Where the term's values go: into the object, or into the object under its @nest.
Json& Compactor::nest_of(Json& result, const ActiveContext& active, const TermDefinition* definition) {
  if (!definition || !definition->nest) return result;
  const std::string& nest = *definition->nest;
  if (nest != "@nest" && expand_iri(active, nest, {true, false}) != "@nest")
    throw JsonLdError("invalid @nest value", place_.pointer(), "\"" + nest + "\" does not mean @nest");
  return map_at(result, nest);
}

/// The object that stands at a key, which is made if absent.
Json& Compactor::map_at(Json& result, const std::string& key) const {
  Json& map = result[key];
  if (map.is_null()) map = Json::object();
  if (!map.is_object())
    throw JsonLdError("colliding containers", place_.pointer(),
                      "\"" + key + "\" would hold an object and other values at once");
  return map;
}

void Compactor::add_list(Json& result, const ContextPtr& active, Item item) {  // 12.8.7
  Json items = as_array(std::move(item.compacted));
  if (item.in("@list")) {
    result[item.key] = std::move(items);
    return;
  }
  item.compacted = Json{{alias(active, kList), std::move(items)}};
  add_wrapped(result, active, std::move(item));
}

/// A list or graph that stands in an object of its own, which says its index unless its place in an index map does.
void Compactor::add_wrapped(Json& result, const ContextPtr& active, Item item) {
  const bool indexed = item.in("@index") && !item.in(kGraph.c_str());
  if (item.expanded.contains("@index") && !(indexed && !item.definition->index))
    item.compacted[alias(active, "@index")] = item.expanded["@index"];
  if (indexed)
    add_to_map(result, active, std::move(item));
  else
    add_compacted(result, item.key, std::move(item.compacted), item.as_array);
}

void Compactor::add_graph(Json& result, const ContextPtr& active, Item item) {  // 12.8.8
  const Json& expanded = item.expanded;
  const auto id = text_of(expanded, "@id");
  const bool simple = !id;
  if (item.in(kGraph.c_str()) && (item.in("@id") || (item.in("@index") && simple))) {
    const auto index = text_of(expanded, "@index");
    const std::string none = alias(active, "@none");
    const std::string key = item.in("@id") ? (id ? compact_iri(active, *id, false) : none) : index.value_or(none);
    add_compacted(map_at(result, item.key), key, std::move(item.compacted), item.as_array);
  } else if (item.in(kGraph.c_str()) && simple) {
    const bool several = item.compacted.is_array() && item.compacted.size() > 1;
    if (several) item.compacted = Json{{alias(active, "@included"), std::move(item.compacted)}};
    add_compacted(result, item.key, std::move(item.compacted), item.as_array);
  } else {
    Json graph{{alias(active, kGraph),
                options_.compact_arrays ? unwrapped(std::move(item.compacted)) : std::move(item.compacted)}};
    if (id) graph[alias(active, "@id")] = compact_iri(active, *id, false);
    item.compacted = std::move(graph);
    add_wrapped(result, active, std::move(item));
  }
}

void Compactor::add_to_map(Json& result, const ContextPtr& active, Item item) {  // 12.8.9
  const Json key = take_map_key(active, item);
  add_compacted(map_at(result, item.key), key.is_string() ? key.get<std::string>() : alias(active, "@none"),
                std::move(item.compacted), item.as_array);
}

Json Compactor::take_map_key(const ContextPtr& active, Item& item) {
  const Json& expanded = item.expanded;
  if (item.in("@language")) {
    const std::string value_key = alias(active, "@value");
    if (is_value(expanded) && item.compacted.is_object()) item.compacted = Json(item.compacted[value_key]);
    return expanded.value("@language", Json());
  }
  if (item.in("@index"))
    return item.definition->index ? take_property_index(active, item) : expanded.value("@index", Json());
  return item.in("@id") ? take_first(item.compacted, alias(active, "@id")) : take_type_key(active, item);
}

Json Compactor::take_property_index(const ContextPtr& active, Item& item) {
  const auto iri = expand_iri(*active, *item.definition->index, {true, false});
  return iri ? take_first(item.compacted, compact_iri(active, *iri, true)) : Json();
}

Json Compactor::take_type_key(const ContextPtr& active, Item& item) {
  Json key = take_first(item.compacted, alias(active, "@type"));
  const bool lonely = item.compacted.is_object() && item.compacted.size() == 1 && item.expanded.contains("@id");
  if (lonely && item.compacted.contains(alias(active, "@id")))
    item.compacted = compact(active, &item.key, Json{{"@id", item.expanded["@id"]}});
  return key;
}

}  // namespace opal::json_ld
