// JSON-LD 1.1 API, 4.2.2: Create Term Definition. Numbers in comments are steps of that section.
#include "jsonld/context/term.hpp"

#include "jsonld/context/iri.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace opal::json_ld {
namespace {

// Terms defined through one another, each longer than the last: bounds the stack and the growth of IRIs.
constexpr int kMaxOpenDefinitions = 64;

constexpr std::array<std::string_view, 11> kEntries{"@id",        "@reverse",   "@container", "@context",
                                                    "@direction", "@index",     "@language",  "@nest",
                                                    "@prefix",    "@protected", "@type"};

[[noreturn]] void refuse(const char* code, const Place& place, const std::string& expected) {
  throw JsonLdError(code, place.pointer(), expected);
}

bool is_iri_or_blank(const std::optional<std::string>& iri) {
  return iri && (is_absolute_iri(*iri) || is_blank_node(*iri));
}

bool has_inner_colon(const std::string& term) {
  const std::size_t colon = term.find(':', 1);
  return colon != std::string::npos && colon + 1 < term.size();
}

bool is_allowed(std::set<std::string, std::less<>> container) {  // 19.1
  const bool set = container.erase("@set") > 0;
  if (container.empty()) return set;
  if (container.size() == 2) return container.count("@graph") && (container.count("@id") || container.count("@index"));
  static constexpr std::array<std::string_view, 5> kSingle{"@graph", "@id", "@index", "@language", "@type"};
  const bool single = std::find(kSingle.begin(), kSingle.end(), *container.begin()) != kSingle.end();
  return container.size() == 1 && (single || (*container.begin() == "@list" && !set));
}

void check_entries(const Json& value, const Place& place) {  // 26
  for (const auto& [key, ignored] : value.items())
    if (std::find(kEntries.begin(), kEntries.end(), key) == kEntries.end())
      refuse("invalid term definition", place.at(key), "expected an entry of term definitions, such as @id or @type");
}

}  // namespace

bool same_meaning(const TermDefinition& a, const TermDefinition& b) {
  const bool same_scope = a.scoped && b.scoped ? a.scoped->context == b.scoped->context : !a.scoped && !b.scoped;
  return same_scope && a.iri == b.iri && a.prefix == b.prefix && a.reverse == b.reverse && a.type == b.type &&
         a.language == b.language && a.direction == b.direction && a.container == b.container && a.index == b.index &&
         a.nest == b.nest;
}

void TermReader::define(const std::string& term) {
  const auto value = local_.find(term);
  if (value == local_.end()) return;
  const Place place = place_.at(std::string_view(value.key()));
  const auto [entry, fresh] = defined_.try_emplace(term, false);  // 1, 2
  if (!fresh && entry->second) return;
  if (!fresh) refuse("cyclic IRI mapping", place, "a term must not be defined through itself");
  if (++open_ > kMaxOpenDefinitions)
    refuse("context overflow", place,
           "terms defined through more than " + std::to_string(kMaxOpenDefinitions) + " others");
  define_from(term, *value, place);
  --open_;
  defined_[term] = true;
}

void TermReader::define_from(const std::string& term, const Json& value, const Place& place) {
  if (term.empty()) refuse("invalid term definition", place, "a term must not be empty");
  if (is_keyword(term))
    check_keyword_term(term, value, place);
  else if (ignores(term, place))
    return;
  const auto before = result_.terms.find(term);  // 6
  const Definition previous = before == result_.terms.end() ? nullptr : before->second;
  if (previous) result_.terms.erase(before);
  if (!value.is_null() && !value.is_string() && !value.is_object())
    refuse("invalid term definition", place, "expected null, an IRI or an object");
  const Json map = value.is_object() ? value : Json{{"@id", value}};
  TermDefinition definition;
  definition.is_protected = protection_ == Protection::all;
  if (map.contains("@protected")) read_protected(definition, map["@protected"], place.at("@protected"));
  if (map.contains("@type")) read_type(definition, map["@type"], place.at("@type"));
  const bool kept =
      map.contains("@reverse") ? read_reverse(definition, map, place) : read_iri(definition, term, value, place);
  if (!kept) return;
  read_use(definition, map, place);
  if (map.contains("@prefix")) read_prefix(definition, term, map["@prefix"], place.at("@prefix"));
  check_entries(map, place);
  store(term, std::move(definition), previous, place);
}

/// 19 to 24: how the values of the term are to be read.
void TermReader::read_use(TermDefinition& definition, const Json& map, const Place& place) {
  const auto entry = [&](const char* key, auto read) {
    const auto found = map.find(key);
    if (found != map.end()) (this->*read)(definition, *found, place.at(key));
  };
  entry("@container", &TermReader::read_container);
  entry("@index", &TermReader::read_index);
  entry("@context", &TermReader::read_scoped);
  if (!map.contains("@type")) entry("@language", &TermReader::read_language);
  if (!map.contains("@type") && map.contains("@direction"))
    definition.direction.emplace(read_direction(map["@direction"], place.at("@direction")));
  entry("@nest", &TermReader::read_nest);
}

void TermReader::read_protected(TermDefinition& definition, const Json& value,
                                const Place& place) const {  // 11
  if (!value.is_boolean()) refuse("invalid @protected value", place, "expected true or false");
  definition.is_protected = value.get<bool>();
}

void TermReader::check_keyword_term(const std::string& term, const Json& value,
                                    const Place& place) const {  // 4, 5
  bool allowed = term == "@type" && value.is_object() && !value.empty();
  if (allowed)
    for (const auto& [key, entry] : value.items())
      allowed = allowed && (key == "@protected" || (key == "@container" && (entry == "@set" || entry == Json{"@set"})));
  if (!allowed) refuse("keyword redefinition", place, term + " must not be defined anew");
}

/// What has the form of a keyword but is none is ignored, or refused where unknown terms are.
bool TermReader::ignores(const std::string& text, const Place& place) const {
  if (is_keyword(text) || !has_keyword_form(text)) return false;
  if (contexts_.options().reject_unknown_terms)
    refuse("unknown keyword", place, text + " has the form of a keyword, but JSON-LD 1.1 has no such keyword");
  return true;
}

std::optional<std::string> TermReader::expand(const std::string& value) {
  return expand_iri(result_, value, {true, false}, [this](const std::string& term) { define(term); });
}

void TermReader::read_type(TermDefinition& definition, const Json& value, const Place& place) {  // 12
  const auto iri = value.is_string() ? expand(value.get<std::string>()) : std::nullopt;
  const bool keyword = iri == "@id" || iri == "@vocab" || iri == "@json" || iri == "@none";
  if (!keyword && !(iri && is_absolute_iri(*iri)))
    refuse("invalid type mapping", place, "expected @id, @vocab, @json, @none or what maps to an IRI");
  definition.type = iri;
}

bool TermReader::read_reverse(TermDefinition& definition, const Json& map, const Place& place) {  // 13
  const Json& value = map["@reverse"];
  if (map.contains("@id") || map.contains("@nest"))
    refuse("invalid reverse property", place, "expected no @id or @nest beside @reverse");
  if (!value.is_string()) refuse("invalid IRI mapping", place.at("@reverse"), "expected an IRI");
  const std::string text = value.get<std::string>();
  if (ignores(text, place.at("@reverse"))) return false;
  definition.iri = expand(text);
  if (!is_iri_or_blank(definition.iri))
    refuse("invalid IRI mapping", place.at("@reverse"), "\"" + text + "\" maps to no IRI");
  const Json container = map.value("@container", Json());
  if (!container.is_null() && container != "@set" && container != "@index")
    refuse("invalid reverse property", place.at("@container"), "expected @set or @index");
  definition.reverse = true;
  return true;
}

/// @return false if the term is to be ignored.
bool TermReader::read_iri(TermDefinition& definition, const std::string& term, const Json& value, const Place& place) {
  if (value.is_object() && !value.contains("@id")) return derive_iri(definition, term, place), true;
  const Json& id = value.is_object() ? value["@id"] : value;
  if (id == term) return derive_iri(definition, term, place), true;
  if (id.is_null()) return true;  // 14.1
  if (!read_given_iri(definition, term, id, place)) return false;
  if (value.is_object() && value.contains("@context") && definition.iri == "@context")
    refuse("invalid keyword alias", place, "@context has no aliases");
  const bool plain = term.find_first_of(":/") == std::string::npos;
  if (plain && value.is_string())  // 14.2.5
    definition.prefix = ends_with_delimiter(*definition.iri) || is_blank_node(*definition.iri);
  return true;
}

bool TermReader::read_given_iri(TermDefinition& definition, const std::string& term, const Json& value,
                                const Place& place) {  // 14.2
  if (!value.is_string()) refuse("invalid IRI mapping", place, "expected a string for @id");
  const std::string text = value.get<std::string>();
  if (ignores(text, place)) return false;
  definition.iri = expand(text);
  if (definition.iri == "@context") refuse("invalid keyword alias", place, "@context has no aliases");
  if (!is_iri_or_blank(definition.iri) && !(definition.iri && is_keyword(*definition.iri)))
    refuse("invalid IRI mapping", place, "\"" + text + "\" maps to no IRI");
  if (has_inner_colon(term) || term.find('/') != std::string::npos) check_iri_like_term(term, *definition.iri, place);
  return true;
}

/// 14.2.4: a term that looks like an IRI must not come to mean another one.
void TermReader::check_iri_like_term(const std::string& term, const std::string& iri, const Place& place) {
  defined_[term] = true;
  if (expand(term) != iri)
    refuse("invalid IRI mapping", place, "the term looks like an IRI, but is mapped to <" + iri + ">");
}

/// 15 to 18: a definition without @id takes its IRI from the term.
void TermReader::derive_iri(TermDefinition& definition, const std::string& term, const Place& place) {
  const std::size_t colon = term.find(':', 1);
  if (colon != std::string::npos) {
    const std::string prefix = term.substr(0, colon);
    define(prefix);
    const TermDefinition* known = result_.find(prefix);
    definition.iri = known && known->iri ? *known->iri + term.substr(colon + 1) : term;
  } else if (term.find('/') != std::string::npos) {
    definition.iri = expand_iri(result_, term, {true, false});
    if (!definition.iri || !is_absolute_iri(*definition.iri))
      refuse("invalid IRI mapping", place, "the term maps to no IRI");
  } else if (term == "@type") {
    definition.iri = "@type";
  } else if (result_.vocab) {
    definition.iri = *result_.vocab + term;
  } else {
    refuse("invalid IRI mapping", place, "expected @id, as there is no @vocab");
  }
}

void TermReader::read_container(TermDefinition& definition, const Json& value, const Place& place) {  // 19
  if (definition.reverse && value.is_null()) return;
  for (const Json& keyword : value.is_array() ? value : Json::array({value}))
    if (keyword.is_string())
      definition.container.insert(keyword.get<std::string>());
    else
      refuse("invalid container mapping", place, "expected a keyword or an array of keywords");
  if (!is_allowed(definition.container))
    refuse("invalid container mapping", place,
           "expected one of @graph, @id, @index, @language, @list, @set, @type or an allowed combination");
  if (!definition.contains("@type")) return;
  if (!definition.type) definition.type = "@id";
  if (definition.type != "@id" && definition.type != "@vocab")
    refuse("invalid type mapping", place, "expected @id or @vocab as the @type of a type map");
}

void TermReader::read_index(TermDefinition& definition, const Json& value, const Place& place) {  // 20
  if (!definition.contains("@index")) refuse("invalid term definition", place, "expected @container to be @index");
  const auto iri = value.is_string() ? expand(value.get<std::string>()) : std::nullopt;
  if (!iri || !is_absolute_iri(*iri)) refuse("invalid term definition", place, "expected what maps to an IRI");
  definition.index = value.get<std::string>();
}

void TermReader::read_scoped(TermDefinition& definition, const Json& value, const Place& place) {  // 21
  ContextUse use = use_;
  use.override_protected = true;
  use.propagate = true;
  use.validate_scoped = false;
  try {
    contexts_.read(std::make_shared<ActiveContext>(result_), value, place, use);
  } catch (const JsonLdError& error) {
    throw JsonLdError("invalid scoped context", error.pointer(), error.what());
  }
  definition.scoped = std::make_shared<ScopedContext>(ScopedContext{value, use_.base, place.pointer()});
}

void TermReader::read_language(TermDefinition& definition, const Json& value, const Place& place) {  // 22
  if (!value.is_null() && !value.is_string())
    refuse("invalid language mapping", place, "expected null or a language tag");
  definition.language.emplace(value.is_null() ? std::nullopt : std::optional(value.get<std::string>()));
}

void TermReader::read_nest(TermDefinition& definition, const Json& value, const Place& place) {  // 24
  if (!value.is_string() || (is_keyword(value.get<std::string>()) && value != "@nest"))
    refuse("invalid @nest value", place, "expected @nest or a term");
  definition.nest = value.get<std::string>();
}

void TermReader::read_prefix(TermDefinition& definition, const std::string& term, const Json& value,
                             const Place& place) {  // 25
  if (term.find_first_of(":/") != std::string::npos)
    refuse("invalid term definition", place, "expected a prefix without ':' and '/'");
  if (!value.is_boolean()) refuse("invalid @prefix value", place, "expected true or false");
  definition.prefix = value.get<bool>();
  if (definition.prefix && definition.iri && is_keyword(*definition.iri))
    refuse("invalid term definition", place, "an alias of a keyword is no prefix");
}

void TermReader::store(const std::string& term, TermDefinition definition, const Definition& before,
                       const Place& place) {  // 27, 28
  const bool keep = before && before->is_protected && !use_.override_protected;
  if (keep && !same_meaning(*before, definition))
    refuse("protected term redefinition", place, "the term is protected by an earlier context");
  // NOLINTNEXTLINE(performance-move-const-arg): make_shared takes it by &&
  result_.terms[term] = keep ? before : std::make_shared<TermDefinition>(std::move(definition));
}

}  // namespace opal::json_ld
