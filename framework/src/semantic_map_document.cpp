#include "map_vocabulary.hpp"
#include "semantic_map_reader.hpp"

#include <opal/error.hpp>
#include <opal/json_ld.hpp>
#include <opal/semantic_map.hpp>
#include <opal/strict_json.hpp>

#include <filesystem>

namespace opal {
namespace {

json_ld::Options strict_options() {
  json_ld::Options options;
  options.contexts[vocabulary::kContextIri] = vocabulary::context_document();
  options.keep_pointers = true;
  options.reject_unknown_terms = true;
  return options;
}

/// What the processor, which knows no vocabulary, cannot say.
std::string expectation(const json_ld::JsonLdError& error) {
  if (error.code() != "unknown term") return "";
  return std::string(", expected a term of ") + vocabulary::kContextIri + " or a name with a prefix, such as opal:Wall";
}

MapDraft draft_of(const nlohmann::json& document, const std::string& source, const std::string& default_name) {
  nlohmann::json nodes;
  try {
    nodes = json_ld::flatten(document, strict_options());
  } catch (const json_ld::JsonLdError& error) {
    throw MapError(source + ": " + error.what() + expectation(error));
  }
  const Graph graph(std::move(nodes), source);
  return read_graph(graph, source, default_name);
}

template <class Parse>
nlohmann::json parsed(Parse parse) {
  try {
    return parse();
  } catch (const JsonError& error) {
    throw MapError(error.what());
  }
}

}  // namespace

std::shared_ptr<const SemanticMap> SemanticMap::read(const std::string& path) {
  const nlohmann::json document = parsed([&] { return read_json(path); });
  return finish(draft_of(document, path, std::filesystem::path(path).stem().string()));
}

std::shared_ptr<const SemanticMap> SemanticMap::parse(const std::string& text, const std::string& name) {
  const nlohmann::json document = parsed([&] { return parse_json(text, name); });
  return finish(draft_of(document, name, name));
}

}  // namespace opal
