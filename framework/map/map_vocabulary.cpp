#include "map/map_vocabulary.hpp"

#include "jsonld/context/iri.hpp"

#include <array>
#include <unordered_map>

namespace opal::vocabulary {
namespace {

using Words = std::unordered_map<std::string, std::string>;

struct Terms {
  Prefixes prefixes;  // "opal" -> "urn:opal:v1#"
  Words iri_of_term;  // "Wall" -> "urn:opal:v1#Wall"
  Words term_of_iri;
};

bool ends_like_a_namespace(const std::string& iri) { return iri.ends_with('#') || iri.ends_with('/'); }

std::string with_prefix_replaced(const std::string& name, const Prefixes& prefixes) {
  const std::size_t colon = name.find(':');
  if (colon == std::string::npos || name.compare(colon + 1, 2, "//") == 0) return name;
  const auto found = prefixes.find(name.substr(0, colon));
  return found == prefixes.end() ? name : found->second + name.substr(colon + 1);
}

Terms terms_of(const nlohmann::json& context) {
  Terms terms;
  for (const auto& [term, definition] : context.items())
    if (definition.is_string() && ends_like_a_namespace(definition)) terms.prefixes[term] = definition;
  for (const auto& [term, definition] : context.items()) {
    if (term.starts_with('@') || terms.prefixes.contains(term)) continue;
    const std::string written = definition.is_string() ? definition : definition.at("@id");
    const std::string iri = with_prefix_replaced(written, terms.prefixes);
    terms.iri_of_term[term] = iri;
    terms.term_of_iri[iri] = term;
  }
  return terms;
}

const Terms& terms() {
  static const Terms built_in = terms_of(context_document().at("@context"));
  return built_in;
}

}  // namespace

const nlohmann::json& context_document() {
  static const nlohmann::json document = nlohmann::json::parse(kContextText);
  return document;
}

std::string compact_name(const std::string& name, const Prefixes& others) {
  const std::string* best_prefix = nullptr;
  std::size_t best_length = 0;
  for (const Prefixes* prefixes : {&terms().prefixes, &others})
    for (const auto& [prefix, iri] : *prefixes)
      if (iri.size() > best_length && name.starts_with(iri) && name.compare(iri.size(), 2, "//") != 0) {
        best_prefix = &prefix;
        best_length = iri.size();
      }
  return best_prefix ? *best_prefix + ":" + name.substr(best_length) : name;
}

std::string full_iri(const std::string& name) {
  const auto term = terms().iri_of_term.find(name);
  return term != terms().iri_of_term.end() ? term->second : with_prefix_replaced(name, terms().prefixes);
}

std::string prefix_of(const std::string& name) {
  const std::size_t colon = name.find(':');
  return colon == std::string::npos || json_ld::is_spelled_out(name) ? "" : name.substr(0, colon);
}

std::string expected_iri(const std::string& word) {
  const std::string prefix = prefix_of(word);
  if (prefix.empty()) return ", expected one that stands for an IRI such as https://... or urn:...";
  return ": @context does not define the prefix '" + prefix + "', expected [\"" + kContextIri + "\", {\"" + prefix +
         "\": \"https://...#\"}]";
}

bool is_term(const std::string& word) { return terms().iri_of_term.contains(word); }
bool is_prefix(const std::string& word) { return terms().prefixes.contains(word); }

std::string iri_of_nameless_prefix(const std::string& prefix) {
  return std::string("urn:opal:prefix:").append(prefix).append(":");
}

std::string short_term(std::string_view name) {
  const auto term = terms().term_of_iri.find(full_iri(std::string(name)));
  return term != terms().term_of_iri.end() ? term->second : compact_name(std::string(name));
}

bool is_own_term(const std::string& iri) { return is_own(iri) && terms().term_of_iri.contains(iri); }

bool is_reserved_type(std::string_view iri) {
  return iri == iri::kSemanticMap || iri == iri::kRepresentation || iri == iri::kPattern || iri == iri::kPlacement ||
         iri == iri::kOverlay || iri == iri::kChange || iri == iri::kConnection || iri == iri::kLanding;
}

bool is_geometry_type(std::string_view iri) {
  return iri == iri::kPoint || iri == iri::kLineSegment || iri == iri::kCorner || iri == iri::kCircle;
}

bool is_object_type(std::string_view iri) {
  return iri == iri::kElement || (is_own(iri) && !is_reserved_type(iri) && !is_geometry_type(iri));
}

std::string default_feature_type(const Geometry& geometry) {
  static const std::array<std::string, 4> by_kind{"opal:Point", "opal:Corner", "opal:Wall", "opal:Column"};
  return by_kind[geometry.index()];
}

}  // namespace opal::vocabulary
