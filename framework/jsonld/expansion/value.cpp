// JSON-LD 1.1 API, 5.3.2: Value Expansion.
#include "jsonld/context/iri.hpp"
#include "jsonld/expansion/expansion.hpp"

namespace opal::json_ld {

void Expander::refuse_unknown(const ActiveContext& active, const std::string& word,
                              const std::optional<std::string>& iri, const Place& place) const {
  if (!options_.reject_unknown_terms) return;
  const TermDefinition* definition = active.find(word);
  if (definition && !definition->iri) return;  // mapped to null, so dropped on purpose
  if (!iri || (!is_absolute_iri(*iri) && !is_blank_node(*iri) && !is_keyword(*iri)))
    throw JsonLdError("unknown term", place.pointer(), "\"" + word + "\" maps to no IRI");
  if (options_.reject_unknown_prefixes && !definition && *iri == word && is_absolute_iri(word) && !is_spelled_out(word))
    throw JsonLdError("unknown prefix", place.pointer(), "the prefix of \"" + word + "\" is not defined");
}

Json Expander::expand_word(const ActiveContext& active, const std::string& word, const Place& place) const {
  const auto iri = expand_iri(active, word, {true, true});
  refuse_unknown(active, word, iri, place);
  return iri ? Json(*iri) : Json();
}

Json Expander::expand_value(const ActiveContext& active, const TermDefinition* definition, const Json& value,
                            const Place& place) const {
  const auto type = definition ? definition->type : std::nullopt;
  if (value.is_string() && type == "@id") return mark({{"@id", expand_id(active, value, place)}}, place);
  if (value.is_string() && type == "@vocab")
    return mark({{"@id", expand_word(active, value.get<std::string>(), place)}}, place);
  Json result{{"@value", value}};
  if (type && type != "@id" && type != "@vocab" && type != "@none") {
    result["@type"] = *type;
  } else if (value.is_string()) {
    const auto language = definition && definition->language ? *definition->language : active.language;
    const auto direction = definition && definition->direction ? *definition->direction : active.direction;
    if (language) result["@language"] = *language;
    if (direction) result["@direction"] = *direction;
  }
  return mark(std::move(result), place);
}

}  // namespace opal::json_ld
