// JSON-LD 1.1 API, 5.1.2, where the frameExpansion flag is set: what frames may say and documents may not.
#include "jsonld/context/iri.hpp"
#include "jsonld/expansion/expansion.hpp"

#include <utility>

namespace opal::json_ld {
namespace {

/// {}: whatever there is.
bool is_wildcard(const Json& value) { return value.is_object() && value.empty(); }

[[noreturn]] void refuse(const char* code, const Place& place, const std::string& expected) {
  throw JsonLdError(code, place.pointer(), expected);
}

bool is_direction(const Json& value) { return value == "ltr" || value == "rtl"; }

/// The value of @embed, @explicit, @omitDefault or @requireAll, as a value object.
Json expand_flag(const Json& value, const Place& place) {
  const Json& flag = value.is_array() && value.size() == 1 ? value[0] : value;
  const Json& plain = flag.is_object() && flag.size() == 1 && flag.contains("@value") ? flag["@value"] : flag;
  if (!plain.is_boolean() && !plain.is_string()) refuse("invalid frame", place, "expected one boolean or keyword");
  return Json::array({Json{{"@value", plain}}});
}

}  // namespace

/// @return false for keywords that mean the same in frames and documents.
bool Expander::expand_frame_keyword(Object& object, const ContextPtr& active, Property property,
                                    const std::string& keyword, const Json& value, const Place& place) {
  Json& result = object.result;
  const bool pattern = keyword == "@id" || keyword == "@type" || keyword == "@value" || keyword == "@language" ||
                       keyword == "@direction";
  if (!pattern && !is_framing_keyword(keyword)) return false;
  if (result.contains(keyword)) refuse("colliding keywords", place, "a second key means " + keyword);
  if (keyword == "@id")
    result[keyword] = expand_id_pattern(*active, value, place);
  else if (keyword == "@type")
    result[keyword] = expand_type_pattern(*object.type_scoped, value, place);
  else if (keyword == "@default")
    result[keyword] = expand_default(active, property, value, place);
  else if (pattern)
    result[keyword] = expand_text_pattern(keyword, value, place);
  else
    result[keyword] = expand_flag(value, place);
  return true;
}

/// 13.4.15: the default is a value of the property, and no pattern; "@null" stands for null.
Json Expander::expand_default(const ContextPtr& active, Property property, const Json& value, const Place& place) {
  Json result = Json::array();
  framing_ = false;
  for (const Json& item : value.is_array() ? value : Json::array({value}))
    if (item == "@null" || !property)
      append(result, Json{{"@value", item}});
    else
      append(result, expand(active, property, item, place));
  framing_ = true;
  return result;
}

Json Expander::expand_id_pattern(const ActiveContext& active, const Json& value, const Place& place) const {
  if (is_wildcard(value)) return Json::array({value});
  Json result = Json::array();
  for (const Json& id : value.is_array() ? value : Json::array({value}))
    if (id.is_string() || (is_wildcard(id) && value.size() == 1))
      result.push_back(id.is_string() ? expand_id(active, id, place) : id);
    else
      refuse("invalid @id value", place, "expected in a frame an IRI, an array of IRIs or {}");
  return result;
}

Json Expander::expand_type_pattern(const ActiveContext& active, const Json& value, const Place& place) const {
  Json result = Json::array();
  for (const Json& type : value.is_array() ? value : Json::array({value})) {
    if (type.is_string()) {
      result.push_back(expand_word(active, type.get<std::string>(), place));
    } else if (is_wildcard(type)) {
      result.push_back(type);
    } else if (type.is_object() && type.size() == 1 && type.contains("@default")) {
      Json given = Json::array();
      for (const Json& word : type["@default"].is_array() ? type["@default"] : Json::array({type["@default"]})) {
        if (!word.is_string()) refuse("invalid type value", place, "expected a string for @default");
        given.push_back(expand_word(active, word.get<std::string>(), place));
      }
      result.push_back(Json{{"@default", std::move(given)}});
    } else {
      refuse("invalid type value", place, "expected in a frame types, {} or an object with @default");
    }
  }
  return result;
}

/// The strings, numbers or booleans that a value may be, say @value: [1, 2]; or {}.
Json Expander::expand_text_pattern(const std::string& keyword, const Json& value, const Place& place) {
  const bool text = keyword != "@value";
  for (const Json& item : value.is_array() ? value : Json::array({value})) {
    const bool fits = is_wildcard(item) || (keyword == "@direction" ? is_direction(item)
                                            : text                  ? item.is_string()
                                                                    : item.is_primitive());
    if (!fits)
      refuse(keyword == "@direction" ? "invalid base direction"
             : text                  ? "invalid language-tagged string"
                                     : "invalid value object value",
             place, "expected in a frame plain values of " + keyword + ", an array of them or {}");
  }
  return as_array(value);
}

}  // namespace opal::json_ld
