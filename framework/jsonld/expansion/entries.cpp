// JSON-LD 1.1 API, 5.1.2, steps 13 and 14: the entries of an object.
#include "jsonld/context/iri.hpp"
#include "jsonld/expansion/expansion.hpp"

#include <utility>

namespace opal::json_ld {

void Expander::expand_entries(Object& object, const ContextPtr& active, Property property, const Json& element,
                              const Place& place) {
  Nests nests;
  for (const auto& [key, value] : element.items()) {
    if (key == "@context") continue;
    const bool frame_word = framing_ && is_framing_keyword(key);
    const auto iri = frame_word ? key : expand_iri(*active, key, {true, false});
    const Place here = place.at(std::string_view(key));
    if (framing_ && expand_frame_keyword(object, active, property, iri.value_or(""), value, here)) continue;
    refuse_unknown(*active, key, iri, here);
    if (!iri || (iri->find(':') == std::string::npos && !is_keyword(*iri))) continue;  // 13.3
    if (iri == "@nest")
      nests[key] = &value;
    else if (is_keyword(*iri))
      expand_keyword(object, active, property, *iri, value, here);
    else
      expand_property(object, active, key, *iri, value, here);
  }
  for (const auto& [key, nested] : nests) expand_nested(object, active, key, *nested, place.at(std::string_view(key)));
}

/// 14.2: nested entries count as if they stood in the object itself.
void Expander::expand_nested(Object& object, const ContextPtr& active, const std::string& key, const Json& nested,
                             const Place& place) {
  if (nested.is_array()) {
    for (std::size_t i = 0; i < nested.size(); ++i) expand_nested(object, active, key, nested[i], place.at(i));
    return;
  }
  const auto refuse = [&] {
    throw JsonLdError("invalid @nest value", place.pointer(), "expected an object without @value");
  };
  if (!nested.is_object()) refuse();
  const TermDefinition* definition = active->find(key);
  const bool scoped = definition && definition->scoped;
  const ContextPtr context = scoped ? contexts_.read_scoped(active, *definition, place, false) : active;
  for (const auto& [inner_key, value] : nested.items())
    if (expand_iri(*context, inner_key, {true, false}) == "@value") refuse();
  expand_entries(object, context, &key, nested, place);
}

void Expander::expand_property(Object& object, const ContextPtr& active, const std::string& key, const std::string& iri,
                               const Json& value, const Place& place) {
  const TermDefinition* definition = active->find(key);
  Json expanded = expand_property_value(active, key, value, place);
  if (expanded.is_null()) return;  // 13.10
  const auto has = [&](const char* keyword) { return definition && definition->contains(keyword); };
  if (has("@list") && !is_list(expanded)) expanded = Json{{"@list", as_array(std::move(expanded))}};  // 13.11
  if (has("@graph") && !has("@id") && !has("@index")) {                                               // 13.12
    expanded = as_array(std::move(expanded));
    for (Json& graph : expanded) graph = mark(Json{{"@graph", as_array(std::move(graph))}}, place);
  }
  if (definition && definition->reverse)
    add_reversed(object.result["@reverse"], iri, std::move(expanded), place);
  else
    add_value(object.result, iri, std::move(expanded));
}

Json Expander::expand_property_value(const ContextPtr& active, const std::string& key, const Json& value,
                                     const Place& place) {  // 13.6 to 13.9
  const TermDefinition* definition = active->find(key);
  if (!definition) return expand(active, &key, value, place);
  if (definition->type == "@json") return mark({{"@value", value}, {"@type", "@json"}}, place);
  if (!value.is_object()) return expand(active, &key, value, place);
  if (definition->contains("@language")) return expand_language_map(*active, *definition, value, place);
  if (definition->contains("@index") || definition->contains("@type") || definition->contains("@id"))
    return expand_index_map(active, *definition, key, value, place);
  return expand(active, &key, value, place);
}

void Expander::add_reversed(Json& result, const std::string& iri, Json values,
                            const Place& place) const {  // 13.13
  values = as_array(std::move(values));
  for (const Json& value : values)
    if (is_value(value) || is_list(value))
      throw JsonLdError("invalid reverse property value", place.pointer(), "expected nodes");
  add_value(result, iri, std::move(values));
}

}  // namespace opal::json_ld
