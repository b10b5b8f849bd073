// JSON-LD 1.1 API, 4.3: Inverse Context Creation, and 6.4: Term Selection.
#include "jsonld/compaction/inverse_context.hpp"

#include <opal/common/letter_case.hpp>

#include <algorithm>
#include <utility>

namespace opal::json_ld {
namespace {

bool shorter_or_first(const std::string& a, const std::string& b) {
  return a.size() == b.size() ? a < b : a.size() < b.size();
}

std::string container_key(const TermDefinition& definition) {
  std::string key;
  for (const std::string& keyword : definition.container) key += keyword;
  return key.empty() ? "@none" : key;
}

}  // namespace

std::string language_key(const std::optional<std::string>& language, const std::optional<std::string>& direction) {
  if (!language && !direction) return "@null";
  std::string key = language ? lower_case_letters(*language) : "";
  if (direction) key += "_" + *direction;
  return key;
}

InverseContext::InverseContext(const ActiveContext& active) {
  const bool silent = !active.language && !active.direction;
  const std::string default_language = silent ? "@none" : language_key(active.language, active.direction);
  std::vector<std::string> names;
  for (const auto& [term, definition] : active.terms)
    if (definition->iri) names.push_back(term);
  std::sort(names.begin(), names.end(), shorter_or_first);
  for (const std::string& term : names) add(term, *active.find(term), default_language);
}

void InverseContext::add(const std::string& term, const TermDefinition& definition,
                         const std::string& default_language) {  // 3
  Kinds& kinds = terms_[*definition.iri][container_key(definition)];
  kinds["@any"].try_emplace("@none", term);
  TermOf& types = kinds["@type"];
  TermOf& languages = kinds["@language"];
  if (definition.reverse) {
    types.try_emplace("@reverse", term);
  } else if (definition.type == "@none") {
    languages.try_emplace("@any", term);
    types.try_emplace("@any", term);
    languages.try_emplace("@none", term);
    types.try_emplace("@none", term);
  } else if (definition.type) {
    types.try_emplace(*definition.type, term);
  } else if (definition.language || definition.direction) {
    const std::optional<std::string> none;
    const std::string key = language_key(definition.language ? *definition.language : none,
                                         definition.direction ? *definition.direction : none);
    const bool no_direction = !definition.language && !*definition.direction;
    languages.try_emplace(no_direction ? "@none" : key, term);
  } else {
    languages.try_emplace(default_language, term);
    languages.try_emplace("@none", term);
    types.try_emplace("@none", term);
  }
  if (!definition.prefix || term.find(':') != std::string::npos) return;
  prefixes_[*definition.iri].push_back(term);
  prefix_lengths_.insert(definition.iri->size());
}

const std::string* InverseContext::select(const std::string& iri, const std::vector<std::string_view>& containers,
                                          std::string_view kind, const std::vector<std::string_view>& preferred) const {
  const Containers& known = terms_.at(iri);
  for (const std::string_view container : containers) {
    const auto kinds = known.find(container);
    if (kinds == known.end()) continue;
    const auto terms = kinds->second.find(kind);
    if (terms == kinds->second.end()) continue;
    for (const std::string_view item : preferred)
      if (const auto term = terms->second.find(item); term != terms->second.end()) return &term->second;
  }
  return nullptr;
}

std::string InverseContext::compact_name(const ActiveContext& active, const std::string& iri, bool bare) const {
  std::string best;
  for (const std::size_t length : prefix_lengths_) {
    if (length >= iri.size()) break;
    const auto terms = prefixes_.find(iri.substr(0, length));
    if (terms == prefixes_.end()) continue;
    for (const std::string& term : terms->second) {
      std::string name = term + ":" + iri.substr(length);
      const TermDefinition* same = active.find(name);
      const bool usable = !same || (bare && same->iri == iri);
      if (usable && (best.empty() || shorter_or_first(name, best))) best = std::move(name);
    }
  }
  return best;
}

}  // namespace opal::json_ld
