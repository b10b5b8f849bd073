// JSON-LD 1.1 API, 4.1.2: Context Processing. Numbers in comments are steps of that section.
#include "jsonld/context/context.hpp"

#include "jsonld/context/iri.hpp"
#include "jsonld/context/term.hpp"

#include <algorithm>
#include <array>

namespace opal::json_ld {
namespace {

constexpr std::size_t kMaxRemoteDepth = 32;
// Contexts that name others twice each would double the work at every level.
constexpr int kMaxLoads = 1000;
constexpr std::size_t kMaxScopedResults = 256;

constexpr std::array<std::string_view, 8> kNoTerms{"@base",      "@direction", "@import",  "@language",
                                                   "@propagate", "@protected", "@version", "@vocab"};

bool has_protected_terms(const ActiveContext& active) {
  return std::ranges::any_of(active.terms, [](const auto& term) { return term.second->is_protected; });
}

bool read_boolean(const Json& value, const std::string& code, const Place& place) {
  if (!value.is_boolean()) throw JsonLdError(code, place.pointer(), "expected true or false");
  return value.get<bool>();
}

void read_base(ActiveContext& result, const Json& value, const Place& place) {  // 5.7
  if (value.is_null()) {
    result.base.reset();
    return;
  }
  const std::string* text = value.get_ptr<const std::string*>();
  if (text && is_absolute_iri(*text))
    result.base = *text;
  else if (text && result.base)
    result.base = resolve_iri(*result.base, *text);
  else
    throw JsonLdError("invalid base IRI", place.pointer(), "expected null or an IRI; a relative one needs a base");
}

void read_vocab(ActiveContext& result, const Json& value, const Place& place) {  // 5.8
  if (value.is_null()) {
    result.vocab.reset();
    return;
  }
  const std::string* text = value.get_ptr<const std::string*>();
  const auto iri = text ? expand_iri(result, *text, {true, true}) : std::nullopt;
  if (!iri) throw JsonLdError("invalid vocab mapping", place.pointer(), "expected null, an IRI or a term");
  result.vocab = iri;
}

void read_language(ActiveContext& result, const Json& value, const Place& place) {  // 5.9
  if (!value.is_null() && !value.is_string())
    throw JsonLdError("invalid default language", place.pointer(), "expected null or a language tag");
  result.language = value.is_null() ? std::nullopt : std::optional(value.get<std::string>());
}

}  // namespace

const TermDefinition* ActiveContext::find(std::string_view term) const {
  const auto found = terms.find(term);
  return found == terms.end() ? nullptr : found->second.get();
}

std::optional<std::string> read_direction(const Json& value, const Place& place) {
  if (value.is_null()) return {};
  if (value != "ltr" && value != "rtl")
    throw JsonLdError("invalid base direction", place.pointer(), "expected null, \"ltr\" or \"rtl\"");
  return value.get<std::string>();
}

ContextPtr ContextReader::initial() const {
  auto result = std::make_shared<ActiveContext>();
  result->original_base = options_.base;
  if (!options_.base.empty()) result->base = options_.base;
  return result;
}

ContextPtr ContextReader::read(const ContextPtr& active, const Json& local, const Place& place, const ContextUse& use) {
  if (open_ == 0) loads_ = 0;
  ++open_;
  const std::shared_ptr<int> closing(&open_, [](int* open) { --*open; });
  ContextUse inner = use;
  if (local.is_object() && local.contains("@propagate"))  // 2
    inner.propagate = read_boolean(local["@propagate"], "invalid @propagate value", place.at("@propagate"));
  auto result = std::make_shared<ActiveContext>(*active);
  if (!inner.propagate && !result->previous) result->previous = active;  // 3
  if (!local.is_array()) return take(result, local, place, inner);
  for (std::size_t i = 0; i < local.size(); ++i) result = take(result, local[i], place.at(i), inner);
  return result;
}

ContextReader::Building ContextReader::take(const Building& current, const Json& context, const Place& place,
                                            const ContextUse& use) {
  if (context.is_null()) return clear(current, place, use);
  if (context.is_string()) return read_remote(current, context.get<std::string>(), place, use);
  if (!context.is_object())
    throw JsonLdError("invalid local context", place.pointer(), "expected null, an IRI or an object");
  read_map(*current, context, place, use);
  return current;
}

ContextReader::Building ContextReader::clear(const Building& current, const Place& place,
                                             const ContextUse& use) const {  // 5.1
  if (!use.override_protected && has_protected_terms(*current))
    throw JsonLdError("invalid context nullification", place.pointer(), "the context has protected terms");
  auto result = std::make_shared<ActiveContext>();
  result->original_base = current->original_base;
  if (!current->original_base.empty()) result->base = current->original_base;
  if (!use.propagate) result->previous = current;
  return result;
}

ContextReader::Building ContextReader::read_remote(const Building& current, const std::string& reference,
                                                   const Place& place, const ContextUse& use) {  // 5.2
  const std::string iri = resolve_iri(use.base, reference);
  const bool seen = std::ranges::find(use.remote, iri) != use.remote.end();
  if (!use.validate_scoped && seen) return current;
  if (use.remote.size() >= kMaxRemoteDepth)
    throw JsonLdError("context overflow", place.pointer(), "contexts that name each other, the last one <" + iri + ">");
  const Json& document = load(iri, place);
  if (!document.is_object() || !document.contains("@context"))
    throw JsonLdError("invalid remote context", place.pointer(), "<" + iri + "> holds no object with @context");
  ContextUse inner;
  inner.base = iri;
  inner.validate_scoped = use.validate_scoped;
  inner.remote = use.remote;
  inner.remote.push_back(iri);
  const std::string prefix = iri + "#";
  const Place root(prefix, &place);
  const ContextPtr result = read(current, document["@context"], root.at("@context"), inner);
  return std::make_shared<ActiveContext>(*result);
}

const Json& ContextReader::load(const std::string& iri, const Place& place) {
  const auto found = options_.contexts.find(iri);
  if (found == options_.contexts.end())
    throw JsonLdError("loading remote context failed", place.pointer(),
                      "<" + iri + "> is none of the contexts known here, and none is fetched");
  if (++loads_ > kMaxLoads)
    throw JsonLdError("context overflow", place.pointer(), "more than " + std::to_string(kMaxLoads) + " contexts");
  return found->second;
}

void ContextReader::read_map(ActiveContext& result, const Json& local, const Place& place, const ContextUse& use) {
  if (local.contains("@version") && local["@version"] != 1.1)  // 5.5
    throw JsonLdError("invalid @version value", place.at("@version").pointer(), "expected the number 1.1");
  if (local.contains("@import")) return read_map(result, with_import(local, place, use), place, use);
  if (local.contains("@base") && use.remote.empty()) read_base(result, local["@base"], place.at("@base"));
  if (local.contains("@vocab")) read_vocab(result, local["@vocab"], place.at("@vocab"));
  if (local.contains("@language")) read_language(result, local["@language"], place.at("@language"));
  if (local.contains("@direction"))  // 5.10
    result.direction = read_direction(local["@direction"], place.at("@direction"));
  if (local.contains("@propagate"))  // 5.11
    read_boolean(local["@propagate"], "invalid @propagate value", place.at("@propagate"));
  define_terms(result, local, place, use);
}

Json ContextReader::with_import(const Json& local, const Place& place, const ContextUse& use) {  // 5.6
  const Place import_place = place.at("@import");
  if (!local["@import"].is_string())
    throw JsonLdError("invalid @import value", import_place.pointer(), "expected the IRI of a context");
  const std::string iri = resolve_iri(use.base, local["@import"].get<std::string>());
  const Json& document = load(iri, import_place);
  if (!document.is_object() || !document.contains("@context") || !document["@context"].is_object())
    throw JsonLdError("invalid remote context", import_place.pointer(),
                      "<" + iri + "> holds no single @context object");
  Json merged = document["@context"];
  if (merged.contains("@import"))
    throw JsonLdError("invalid context entry", import_place.pointer(), "<" + iri + "> imports a context itself");
  merged.update(local);
  merged.erase("@import");
  return merged;
}

void ContextReader::define_terms(ActiveContext& result, const Json& local, const Place& place,
                                 const ContextUse& use) {  // 5.12, 5.13
  TermReader terms(*this, result, local, place, use);
  if (local.contains("@protected"))
    if (read_boolean(local["@protected"], "invalid @protected value", place.at("@protected")))
      terms.protect(TermReader::Protection::all);
  for (const auto& [term, definition] : local.items())
    if (std::ranges::find(kNoTerms, term) == kNoTerms.end()) terms.define(term);
}

ContextPtr ContextReader::read_scoped(const ContextPtr& active, const TermDefinition& definition, const Place& place,
                                      bool type_scoped) {
  const std::shared_ptr<const ScopedContext> scoped = definition.scoped;
  const ScopedKey key(active.get(), scoped.get(), type_scoped);
  const auto known = scoped_results_.find(key);
  if (known != scoped_results_.end()) return known->second.result;
  ContextUse use;
  use.base = scoped->base;
  use.override_protected = !type_scoped;
  use.propagate = !type_scoped;
  const ContextPtr result = read(active, scoped->context, Place(scoped->document, &place), use);
  if (scoped_results_.size() >= kMaxScopedResults) scoped_results_.clear();
  scoped_results_[key] = {active, result, scoped};
  return result;
}

}  // namespace opal::json_ld
