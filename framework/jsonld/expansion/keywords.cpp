// JSON-LD 1.1 API, 5.1.2, step 13.4: entries whose key is a keyword or an alias of one.
#include "jsonld/context/term.hpp"
#include "jsonld/expansion/expansion.hpp"

#include <utility>

namespace opal::json_ld {
namespace {

const std::string kGraph = "@graph";
const std::string kIncluded = "@included";
const std::string kReverse = "@reverse";

Json require_string(const Json& value, const char* code, const Place& place) {
  if (!value.is_string()) throw JsonLdError(code, place.pointer(), "expected a string");
  return value;
}

Json require_direction(const Json& value, const Place& place) {
  if (!value.is_string()) throw JsonLdError("invalid base direction", place.pointer(), "expected \"ltr\" or \"rtl\"");
  return *read_direction(value, place);
}

Json to_elements(Json expanded) { return expanded.is_null() ? Json::array() : as_array(std::move(expanded)); }

}  // namespace

void Expander::expand_keyword(Object& object, const ContextPtr& active, Property property, const std::string& keyword,
                              const Json& value, const Place& place) {
  Json& result = object.result;
  if (property && *property == kReverse)
    throw JsonLdError("invalid reverse property map", place.pointer(), "expected no keywords inside @reverse");
  if (result.contains(keyword) && keyword != "@included" && keyword != "@type" && keyword != "@reverse")
    throw JsonLdError("colliding keywords", place.pointer(), "a second key means " + keyword);
  if (keyword == "@id")
    result[keyword] = expand_id(*active, value, place);
  else if (keyword == "@type")
    expand_types(result, *object.type_scoped, value, place);
  else if (keyword == "@graph")
    result[keyword] = to_elements(expand(active, &kGraph, value, place));
  else if (keyword == "@included")
    add_value(result, keyword, expand_included(active, value, place));
  else if (keyword == "@value")
    expand_value_entry(object, value, place);
  else if (keyword == "@language")
    result[keyword] = require_string(value, "invalid language-tagged string", place);
  else if (keyword == "@direction")
    result[keyword] = require_direction(value, place);
  else if (keyword == "@index")
    result[keyword] = require_string(value, "invalid @index value", place);
  else if (keyword == "@list")
    expand_list(result, active, property, value, place);
  else if (keyword == "@set")
    expand_set(result, active, property, value, place);
  else if (keyword == "@reverse")
    expand_reverse(object, active, value, place);
  else if (options_.reject_unknown_terms)
    throw JsonLdError("misplaced keyword", place.pointer(), keyword + " has no meaning outside a context");
}

Json Expander::expand_id(const ActiveContext& active, const Json& value,
                         const Place& place) const {  // 13.4.3
  const auto iri = expand_iri(active, require_string(value, "invalid @id value", place), {false, true});
  if (!iri && options_.reject_unknown_terms)
    throw JsonLdError("unknown keyword", place.pointer(), "expected an IRI, which does not start like a keyword");
  return iri ? Json(*iri) : Json();
}

void Expander::expand_types(Json& result, const ActiveContext& active, const Json& value,
                            const Place& place) const {  // 13.4.4
  Json types;
  if (value.is_string())
    types = expand_word(active, value.get<std::string>(), place);
  else if (value.is_array())
    types = Json::array();
  else
    throw JsonLdError("invalid type value", place.pointer(), "expected a string or an array of strings");
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i)
      types.push_back(expand_word(active, require_string(value[i], "invalid type value", place.at(i)), place.at(i)));
  if (!result.contains("@type")) {
    result["@type"] = std::move(types);
    return;
  }
  result["@type"] = as_array(std::move(result["@type"]));
  add_value(result, "@type", std::move(types));
}

Json Expander::expand_included(const ContextPtr& active, const Json& value, const Place& place) {  // 13.4.6
  Json nodes = to_elements(expand(active, &kIncluded, value, place));
  for (const Json& node : nodes)
    if (!node.is_object() || is_value(node) || is_list(node))
      throw JsonLdError("invalid @included value", place.pointer(), "expected nodes");
  return nodes;
}

void Expander::expand_value_entry(Object& object, const Json& value, const Place& place) const {  // 13.4.7
  if (object.value_type != "@json" && value.is_structured())
    throw JsonLdError("invalid value object value", place.pointer(), "expected a string, number, boolean or null");
  object.result["@value"] = value;
}

void Expander::expand_list(Json& result, const ContextPtr& active, Property property, const Json& value,
                           const Place& place) {  // 13.4.11
  const bool top = !property || *property == kGraph;
  if (!top)
    result["@list"] = to_elements(expand(active, property, value, place));
  else if (options_.reject_unknown_terms)
    throw JsonLdError("free-floating value", place.pointer(), "expected a node; JSON-LD drops lists here");
}

void Expander::expand_set(Json& result, const ContextPtr& active, Property property, const Json& value,
                          const Place& place) {  // 13.4.12
  Json elements = expand(active, property, value, place);
  if (!elements.is_null()) result["@set"] = std::move(elements);
}

void Expander::expand_reverse(Object& object, const ContextPtr& active, const Json& value,
                              const Place& place) {  // 13.4.13
  if (!value.is_object()) throw JsonLdError("invalid @reverse value", place.pointer(), "expected an object");
  Json expanded = expand(active, &kReverse, value, place);
  if (!expanded.is_object()) return;
  for (auto& [iri, values] : expanded.items()) {
    if (iri == kPointer) continue;
    if (iri != kReverse) {
      add_reversed(object.result[kReverse], iri, std::move(values), place);
      continue;
    }
    for (auto& [forward, nodes] : values.items()) add_value(object.result, forward, std::move(nodes));
  }
}

}  // namespace opal::json_ld
