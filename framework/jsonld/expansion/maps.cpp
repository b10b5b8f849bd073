// JSON-LD 1.1 API, 5.1.2, steps 13.7 and 13.8: containers that are objects keyed by language, index, id or
// type.
#include "jsonld/expansion/expansion.hpp"

#include <utility>

namespace opal::json_ld {

Json Expander::expand_language_map(const ActiveContext& active, const TermDefinition& definition, const Json& value,
                                   const Place& place) const {  // 13.7
  Json result = Json::array();
  const auto direction = definition.direction ? *definition.direction : active.direction;
  for (const auto& [language, entry] : value.items()) {
    const Place here = place.at(std::string_view(language));
    const bool tagged = expand_iri(active, language, {true, false}) != "@none";
    for (const Json& item : entry.is_array() ? entry : Json::array({entry})) {
      if (item.is_null()) continue;
      if (!item.is_string()) throw JsonLdError("invalid language map value", here.pointer(), "expected strings");
      Json text{{"@value", item}};
      if (tagged) text["@language"] = language;
      if (direction) text["@direction"] = *direction;
      result.push_back(mark(std::move(text), here));
    }
  }
  return result;
}

Json Expander::expand_index_map(const ContextPtr& active, const TermDefinition& definition, const std::string& key,
                                const Json& value, const Place& place) {  // 13.8
  Json result = Json::array();
  for (const auto& [index, entry] : value.items()) {
    const Place here = place.at(std::string_view(index));
    const ContextPtr context = map_context(active, definition, index, here);
    Json items = expand(context, &key, entry, here, true);
    if (items.is_null()) continue;
    items = as_array(std::move(items));
    for (Json& item : items) {
      if (definition.contains("@graph") && !is_graph(item))
        item = mark(Json{{"@graph", as_array(std::move(item))}}, here);
      if (expand_iri(*active, index, {true, false}) != "@none") add_index(item, *active, definition, index, here);
      result.push_back(std::move(item));
    }
  }
  return result;
}

ContextPtr Expander::map_context(const ContextPtr& active, const TermDefinition& definition, const std::string& index,
                                 const Place& place) {  // 13.8.3.1 to 13.8.3.3
  if (!definition.contains("@id") && !definition.contains("@type")) return active;
  const ContextPtr context = active->previous ? active->previous : active;
  if (!definition.contains("@type")) return context;
  const TermDefinition* type = context->find(index);
  return type && type->scoped ? contexts_.read_scoped(context, *type, place, true) : context;
}

/// 13.8.3.7: what the key says about the item.
void Expander::add_index(Json& item, const ActiveContext& active, const TermDefinition& definition,
                         const std::string& index, const Place& place) const {
  if (definition.contains("@index") && definition.index) {
    add_property_index(item, active, *definition.index, index, place);
  } else if (definition.contains("@index")) {
    if (!item.contains("@index")) item["@index"] = index;
  } else if (definition.contains("@id")) {
    if (!item.contains("@id")) item["@id"] = expand_id(active, index, place);
  } else {
    Json types = Json::array({expand_word(active, index, place)});
    if (item.contains("@type")) types.insert(types.end(), item["@type"].begin(), item["@type"].end());
    item["@type"] = std::move(types);
  }
}

void Expander::add_property_index(Json& item, const ActiveContext& active, const std::string& index_key,
                                  const std::string& index, const Place& place) const {  // 13.8.3.7.2
  if (is_value(item))
    throw JsonLdError("invalid value object", place.pointer(),
                      "a value cannot take the property \"" + index_key + "\"");
  const std::string iri = *expand_iri(active, index_key, {true, false});
  Json values = Json::array({expand_value(active, active.find(index_key), index, place)});
  if (item.contains(iri)) values.insert(values.end(), item[iri].begin(), item[iri].end());
  item[iri] = std::move(values);
}

}  // namespace opal::json_ld
