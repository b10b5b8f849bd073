// JSON-LD 1.1 API, 6.2.2: IRI Compaction, and 6.5: Value Compaction. Numbers in comments are steps of the former.
#include "jsonld/compaction/compaction.hpp"
#include "jsonld/context/iri.hpp"

#include <opal/common/letter_case.hpp>

#include <optional>
#include <string_view>
#include <utility>

namespace opal::json_ld {
namespace {

constexpr std::size_t kMaxInverses = 256;
constexpr std::size_t kMaxNames = 4096;

using Texts = std::vector<std::string_view>;

/// What a term must say of its values to be used for one.
struct Wanted {
  std::string kind = "@language", value = "@null";
};

Wanted wanted_for_value(const Json& value) {
  const auto language = text_of(value, "@language"), direction = text_of(value, "@direction");
  if (language || direction) return {"@language", language_key(language, direction)};
  if (const auto type = text_of(value, "@type")) return {"@type", *type};
  return {};
}

/// 4.7: the most that all items of a list have in common.
Wanted wanted_for_list(const Json& items) {
  if (items.empty()) return {"@any", "@none"};
  std::optional<std::string> language, type;
  for (const Json& item : items) {
    std::string item_language = "@none", item_type = "@none";
    if (is_value(item)) {
      const Wanted wanted = wanted_for_value(item);
      (wanted.kind == "@type" ? item_type : item_language) = wanted.value;
    } else {
      item_type = "@id";
    }
    if (!language) language = item_language;
    if (*language != item_language && is_value(item)) language = "@none";
    if (!type) type = item_type;
    if (*type != item_type) type = "@none";
  }
  if (*type != "@none") return {"@type", *type};
  return {"@language", *language};
}

void add_graph_containers(const Json& value, Texts& containers) {  // 4.8
  const Texts by_index{"@graph@index", "@graph@index@set"}, by_id{"@graph@id", "@graph@id@set"};
  const auto add = [&](const Texts& texts) { containers.insert(containers.end(), texts.begin(), texts.end()); };
  if (value.contains("@index")) add(by_index);
  if (value.contains("@id")) add(by_id);
  add({"@graph", "@graph@set", "@set"});
  if (!value.contains("@index")) add(by_index);
  if (!value.contains("@id")) add(by_id);
  add({"@index", "@index@set"});
}

/// 4.4 to 4.12: the containers that would do, the most telling first.
Texts containers_for(const Json* value, bool reverse) {
  Texts containers;
  containers.reserve(16);
  const auto add = [&](const Texts& texts) { containers.insert(containers.end(), texts.begin(), texts.end()); };
  const bool object = value && value->is_object(), index = object && value->contains("@index");
  if (index && !is_graph_object(*value)) add({"@index", "@index@set"});
  if (reverse) {
    add({"@set"});
  } else if (object && is_list(*value)) {
    if (!index) add({"@list"});
  } else if (object && is_graph_object(*value)) {
    add_graph_containers(*value, containers);
  } else {
    const bool spoken = object && is_value(*value) && (value->contains("@language") || value->contains("@direction"));
    if (spoken && !index) add({"@language", "@language@set"});
    if (object && !is_value(*value)) add({"@id", "@id@set", "@type", "@set@type"});
    add({"@set"});
  }
  add({"@none"});
  if (!index) add({"@index", "@index@set"});
  if (object && is_value(*value) && value->size() == 1) add({"@language", "@language@set"});
  return containers;
}

Wanted wanted_for(const Json* value, bool reverse) {
  if (reverse) return {"@type", "@reverse"};
  if (!value || !value->is_object()) return {"@type", "@id"};
  if (is_list(*value)) return wanted_for_list((*value)["@list"]);
  if (is_value(*value)) return wanted_for_value(*value);
  return {"@type", "@id"};
}

bool same_language(const std::optional<std::string>& a, const std::optional<std::string>& b) {
  return a.has_value() == b.has_value() && (!a || lower_case_letters(*a) == lower_case_letters(*b));
}

}  // namespace

const InverseContext& Compactor::inverse_of(const ContextPtr& active) {
  const auto known = inverses_.find(active.get());
  if (known != inverses_.end()) return *known->second.inverse;
  if (inverses_.size() >= kMaxInverses) inverses_.clear();
  Inverse& made = inverses_[active.get()];
  made.active = active;
  made.inverse = std::make_unique<InverseContext>(*active);
  return *made.inverse;
}

std::string Compactor::compact_iri(const ContextPtr& active, const std::string& iri, bool vocabulary, const Json* value,
                                   bool reverse) {
  if (value) return find_name(active, iri, vocabulary, value, reverse);
  (void)inverse_of(active);
  auto& names = inverses_.at(active.get()).names[vocabulary ? 1 : 0];
  if (names.size() >= kMaxNames) names.clear();
  if (const auto known = names.find(iri); known != names.end()) return known->second;
  std::string name = find_name(active, iri, vocabulary, nullptr, reverse);
  return inverses_.at(active.get()).names[vocabulary ? 1 : 0][iri] = std::move(name);
}

std::string Compactor::find_name(const ContextPtr& active, const std::string& iri, bool vocabulary, const Json* value,
                                 bool reverse) {
  const InverseContext& inverse = inverse_of(active);
  if (vocabulary && inverse.knows(iri))
    if (const std::string* term = select_term(active, iri, value, reverse)) return *term;
  if (is_keyword(iri)) return iri;
  if (vocabulary && active->vocab && iri.size() > active->vocab->size() && iri.rfind(*active->vocab, 0) == 0) {
    std::string suffix = iri.substr(active->vocab->size());
    if (!active->find(suffix)) return suffix;
  }
  if (std::string name = inverse.compact_name(*active, iri, value == nullptr); !name.empty()) return name;
  const std::size_t colon = iri.find(':');
  const TermDefinition* confused = colon == std::string::npos ? nullptr : active->find(iri.substr(0, colon));
  if (confused && confused->prefix && iri.compare(colon, 3, "://") != 0)
    throw JsonLdError("IRI confused with prefix", place_.pointer(),
                      "<" + iri + "> would be read as a name with the prefix of the context");
  return vocabulary || !active->base ? iri : relative_iri(*active->base, iri);
}

const std::string* Compactor::select_term(const ContextPtr& active, const std::string& iri, const Json* value,
                                          bool reverse) {
  const Wanted wanted = wanted_for(value, reverse);
  static const Json nothing;
  const Texts values = preferred(active, wanted.value, value ? *value : nothing);
  return inverse_of(active).select(iri, containers_for(value, reverse), wanted.kind, values);
}

/// 4.14 to 4.18
std::vector<std::string_view> Compactor::preferred(const ContextPtr& active, const std::string& wanted,
                                                   const Json& value) {
  Texts result;
  if (wanted == "@reverse") result.push_back(wanted);
  const auto id = value.is_object() ? text_of(value, "@id") : std::nullopt;
  if ((wanted == "@id" || wanted == "@reverse") && id) {
    const TermDefinition* definition = active->find(compact_iri(active, *id, true));
    const bool is_word = definition && definition->iri == *id;
    const Texts order = is_word ? Texts{"@vocab", "@id"} : Texts{"@id", "@vocab"};
    result.insert(result.end(), order.begin(), order.end());
  } else if (wanted != "@reverse") {
    result.push_back(wanted);
  }
  const std::size_t direction = wanted.rfind('_');
  if (direction != std::string::npos && direction > 0) result.push_back(std::string_view(wanted).substr(direction));
  result.push_back("@none");
  return result;
}

Json Compactor::compact_value(const ContextPtr& active, const TermDefinition* definition, const Json& value) {  // 6.5
  const auto type = definition ? definition->type : std::nullopt;
  if (!is_value(value)) {
    const std::string id = value["@id"].is_string() ? value["@id"].get<std::string>() : "";
    if (type == "@id") return compact_iri(active, id, false);
    if (type == "@vocab") return compact_iri(active, id, true);
    return value;
  }
  const bool indexed = definition && definition->contains("@index");
  const bool index_said = !value.contains("@index") || indexed;
  const auto value_type = text_of(value, "@type");
  const auto language = definition && definition->language ? *definition->language : active->language;
  const auto direction = definition && definition->direction ? *definition->direction : active->direction;
  const Json& plain = value["@value"];
  if (index_said && type != "@none") {
    if (value_type && value_type == type) return plain;
    const bool same = same_language(text_of(value, "@language"), language) && text_of(value, "@direction") == direction;
    if (!value_type && (!plain.is_string() || same)) return plain;
  }
  Json result = Json::object();
  for (const auto& [key, entry] : value.items()) {
    if (key == "@index" && indexed) continue;
    const bool names = key == "@type" && entry.is_string();
    result[alias(active, key)] = names ? Json(compact_iri(active, entry.get<std::string>(), true)) : entry;
  }
  return result;
}

}  // namespace opal::json_ld
