#include "map/document/plain_document.hpp"

#include "common/json/json_elements.hpp"
#include "jsonld/context/iri.hpp"
#include "map/document/plain_objects.hpp"
#include "map/map_vocabulary.hpp"

#include <algorithm>

namespace opal {
namespace {

using nlohmann::json;
using namespace vocabulary;

bool is_whole_prefix(const std::string& iri) {
  return json_ld::is_spelled_out(iri) && json_ld::ends_with_delimiter(iri);
}

/// A part of a context that defines nothing but prefixes, of which Opal's context knows none.
bool defines_prefixes_only(const json& part) {
  if (!part.is_object()) return false;
  for (const auto& [word, iri] : part.items()) {
    const bool is_free = !is_term(word) && !is_prefix(word) && word.find_first_of(":@") == std::string::npos;
    if (!is_free || word.empty() || !iri.is_string() || !is_whole_prefix(iri.get_ref<const std::string&>()))
      return false;
  }
  return true;
}

bool is_plain_context(const json& context) {
  if (!context.is_array()) return context == kContextIri;
  return !context.empty() && context.front() == kContextIri &&
         std::all_of(context.begin() + 1, context.end(), defines_prefixes_only);
}

void add_texts(const json& value, std::unordered_set<std::string>& texts) {
  if (value.is_string()) texts.insert(value.get<std::string>());
  if (value.is_structured())
    for (const json& part : value) add_texts(part, texts);
}

/// A type as a JSON-LD processor expands it.
std::string plain_type(const std::string& written, const Prefixes& prefixes) {
  if (is_term(written)) return full_iri(written);
  const std::size_t colon = written.find(':');
  if (colon == std::string::npos || written.compare(colon + 1, 2, "//") == 0) throw NotPlain();
  const std::string prefix = written.substr(0, colon);
  if (is_prefix(prefix)) return full_iri(written);
  const auto own = prefixes.find(prefix);
  if (own == prefixes.end()) throw NotPlain();
  return own->second + written.substr(colon + 1);
}

void expand_types(MapDraft& draft) {
  for (MapObject& object : draft.objects) object.type = plain_type(object.type, draft.prefixes);
  for (MapFeature& feature : draft.features)
    if (!feature.type.empty()) feature.type = plain_type(feature.type, draft.prefixes);
}

/// @throws NotPlain if what was taken and what was not speak of each other.
void require_apart(const json& rest, const PlainObjects& taken) {
  std::unordered_set<std::string> texts;
  add_texts(rest["@graph"], texts);
  if (taken.defines_any(texts) || !taken.sensors_are_used()) throw NotPlain();
}

MapDraft read(const std::string& text, const std::string& name,
              const std::function<MapDraft(const json& rest)>& read_rest, const JsonLimits& limits) {
  PlainObjects objects;
  const JsonElements elements{"@graph", [&objects](const json& node) { return objects.take(node); }};
  const json rest = parse_json_elements(text, name, elements, limits);
  if (!rest.is_object() || rest.size() != 2 || !rest.contains("@context") || !rest.contains("@graph") ||
      !rest["@graph"].is_array() || !is_plain_context(rest["@context"]))
    throw NotPlain();
  require_apart(rest, objects);
  MapDraft draft = read_rest(rest);
  if (!draft.patterns.empty() || !draft.objects.empty()) throw NotPlain();
  objects.finish(draft);
  expand_types(draft);
  return draft;
}

}  // namespace

std::optional<MapDraft> read_plain_document(const std::string& text, const std::string& name,
                                            const std::function<MapDraft(const json& rest)>& read_rest,
                                            const JsonLimits& limits) {
  try {
    return read(text, name, read_rest, limits);
  } catch (const NotPlain&) {
  } catch (const Error&) {  // what is wrong, and where, is the general reader's to say
  }
  return std::nullopt;
}

}  // namespace opal
