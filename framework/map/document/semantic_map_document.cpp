#include "map/document/semantic_map_document.hpp"

#include "common/json/json_elements.hpp"
#include "jsonld/context/iri.hpp"
#include "map/document/plain_document.hpp"
#include "map/document/semantic_map_reader.hpp"
#include "map/map_vocabulary.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include <opal/map/semantic_map.hpp>
#include "jsonld/json_ld.hpp"

#include <filesystem>

namespace opal {

namespace {

/// What a function reads; its complaints are those of a map.
template <class Read>
auto of_a_map(Read read) {
  try {
    return read();
  } catch (const JsonError& error) {
    throw MapError(error.what());
  }
}

}  // namespace

nlohmann::json read_document(const std::string& path) {
  return of_a_map([&] { return read_json(path); });
}

nlohmann::json parse_document(const std::string& text, const std::string& name) {
  return of_a_map([&] { return parse_json(text, name); });
}

/// What to call a document in messages, and its map if it has no name of its own.
struct MapSource {
  std::string name;
  std::string default_map_name;
};

namespace {

json_ld::Options strict_options(bool keep_pointers) {
  json_ld::Options options;
  options.contexts[vocabulary::kContextIri] = vocabulary::context_document();
  options.keep_pointers = keep_pointers;
  options.reject_unknown_terms = true;
  return options;
}

/// What the processor, which knows no vocabulary, cannot say.
std::string expectation(const json_ld::JsonLdError& error) {
  if (error.code() == "unknown prefix") return ", expected one that the document's @context defines";
  if (error.code() != "unknown term") return "";
  return std::string(", expected a term of ") + vocabulary::kContextIri + " or a name with a prefix, such as opal:Wall";
}

/// Adds the prefixes that an object of a context defines; those of whole IRIs only, and none that Opal's context has.
void add_prefixes(const nlohmann::json& context, vocabulary::Prefixes& prefixes) {
  for (const auto& [word, definition] : context.items()) {
    if (!definition.is_string() || vocabulary::is_term(word) || vocabulary::is_prefix(word)) continue;
    const std::string iri = definition;
    if (json_ld::is_spelled_out(iri) && json_ld::ends_with_delimiter(iri) &&
        word.find_first_of(":@") == std::string::npos)
      prefixes[word] = iri;
  }
}

}  // namespace

vocabulary::Prefixes prefixes_of(const nlohmann::json& document) {
  vocabulary::Prefixes prefixes;
  if (!document.is_object() || !document.contains("@context")) return prefixes;
  const nlohmann::json& context = document["@context"];
  if (context.is_object()) add_prefixes(context, prefixes);
  if (context.is_array())
    for (const nlohmann::json& part : context)
      if (part.is_object()) add_prefixes(part, prefixes);
  return prefixes;
}

nlohmann::json flattened_document(const nlohmann::json& document, const std::string& source, bool keep_pointers) {
  try {
    return json_ld::flatten(document, strict_options(keep_pointers));
  } catch (const json_ld::JsonLdError& error) {
    throw MapError(source + ": " + error.what() + expectation(error));
  }
}

namespace {

MapDraft draft_of(const nlohmann::json& document, const MapSource& source, bool keep_pointers) {
  const Graph graph(flattened_document(document, source.name, keep_pointers), source.name);
  MapDraft draft = read_graph(graph, source.name, source.default_map_name);
  draft.prefixes = prefixes_of(document);
  return draft;
}

}  // namespace

// Where things stand in the document is only of interest if something is wrong with it, and knowing it takes more
// memory and time than all the rest: so a document with a fault is read a second time. Faults of patterns show later,
// when their templates are at hand, so a document with patterns is read with places at once.
std::shared_ptr<const SemanticMap> SemanticMap::from_document(const nlohmann::json& document, const MapSource& source) {
  try {
    MapDraft draft = draft_of(document, source, false);
    return finish(draft.patterns.empty() ? std::move(draft) : draft_of(document, source, true));
  } catch (const MapError&) {
    return finish(draft_of(document, source, true));
  }
}

namespace {

/// A plain document takes three bytes of memory for one of text, any other takes twenty.
constexpr JsonLimits kPlainLimits{.bytes = std::size_t{1} << 30};

std::optional<MapDraft> plain_draft(const std::string& text, const MapSource& source) {
  const auto read_rest = [&](const nlohmann::json& rest) { return draft_of(rest, source, false); };
  std::optional<MapDraft> draft = read_plain_document(text, source.name, read_rest, kPlainLimits);
  if (!draft && text.size() > JsonLimits().bytes && text.size() <= kPlainLimits.bytes)
    throw MapError(source.name + ": " + std::to_string(text.size()) + " bytes, expected at most " +
                   std::to_string(JsonLimits().bytes) +
                   " of a document with a fault, a pattern layer, or words that "
                   "`opal map` does not write");
  return draft;
}

/// @param finish   makes a map of a draft.
/// @param general  makes one of a document, by the general reader.
template <class Finish, class General>
std::shared_ptr<const SemanticMap> map_of(const std::string& text, const MapSource& source, Finish finish,
                                          General general) {
  if (std::optional<MapDraft> plain = plain_draft(text, source)) try {
      return finish(std::move(*plain));
    } catch (const MapError&) {  // which place it is, the general reader knows
    }
  return general(parse_document(text, source.name), source);
}

}  // namespace

std::shared_ptr<const SemanticMap> SemanticMap::read(const std::string& path) {
  const std::string text = of_a_map([&] { return read_json_text(path, kPlainLimits); });
  return map_of(text, {path, std::filesystem::path(path).stem().string()}, finish, from_document);
}

std::shared_ptr<const SemanticMap> SemanticMap::parse(const std::string& text, const std::string& name) {
  return map_of(text, {name, name}, finish, from_document);
}

}  // namespace opal
