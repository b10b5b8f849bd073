// JSON-LD 1.1 Framing, 4.2.3: Frame Matching, and 4.2.4: Value Pattern Matching.
#include "jsonld/context/iri.hpp"
#include "jsonld/framing/framing.hpp"

#include <algorithm>

namespace opal::json_ld {
namespace {

const Json& values_of(const Json& object, const std::string& key) {
  static const Json none = Json::array();
  const auto found = object.find(key);
  return found == object.end() ? none : *found;
}

/// A pattern is an array, or the one name that a term's type or a map's key gave.
bool is_wildcard(const Json& pattern) {
  return pattern.is_array() && pattern.size() == 1 && pattern[0].is_object() && pattern[0].empty();
}

bool contains(const Json& array, const Json& value) { return std::ranges::find(array, value) != array.end(); }

/// Whether what a value says under a key is what its pattern wants there.
bool entry_matches(const Json& value, const Json& pattern, const char* key) {
  const Json wanted = as_array(values_of(pattern, key));
  const auto found = value.find(key);
  if (found == value.end() || found->is_null()) return wanted.empty();
  return is_wildcard(wanted) || contains(wanted, *found);
}

template <class Matches>
bool any_of(const Json& values, Matches matches) {
  return std::ranges::any_of(values, matches);
}

}  // namespace

bool value_matches(const Json& value, const Json& pattern) {
  const bool says = pattern.contains("@value") || pattern.contains("@type") || pattern.contains("@language") ||
                    pattern.contains("@direction");
  if (!says) return true;
  if (!is_value(value)) return false;
  return entry_matches(value, pattern, "@value") && entry_matches(value, pattern, "@type") &&
         entry_matches(value, pattern, "@language") &&
         (!pattern.contains("@direction") || entry_matches(value, pattern, "@direction"));
}

bool FrameMatcher::matches(const Json& node, const Json& frame, bool require_all) const {
  bool wildcard = true, some = false;
  for (const auto& [key, pattern] : frame.items()) {
    if (key != "@id" && key != "@type" && (is_keyword(key) || is_framing_keyword(key))) continue;
    if (key != "@id") wildcard = false;
    const Verdict verdict = key == "@id"     ? match_id(node, pattern)
                            : key == "@type" ? match_type(node, pattern)
                                             : match_property(values_of(node, key), pattern, require_all);
    if (verdict == Verdict::skip) continue;
    if (verdict == Verdict::decides_no) return false;
    const bool matched = verdict == Verdict::yes;
    const bool decides = key == "@id" || (key == "@type" && !pattern.empty() && !is_wildcard(pattern));
    if (decides && !require_all) return matched;
    if (!matched && require_all) return false;
    some = some || matched;
  }
  return wildcard || some;
}

FrameMatcher::Verdict FrameMatcher::match_id(const Json& node, const Json& pattern) const {
  const bool any = pattern.empty() || is_wildcard(pattern);
  return any || contains(pattern, node.at("@id")) ? Verdict::yes : Verdict::no;
}

FrameMatcher::Verdict FrameMatcher::match_type(const Json& node, const Json& pattern) const {
  const Json& types = values_of(node, "@type");
  if (pattern.empty()) return types.empty() ? Verdict::yes : Verdict::decides_no;
  if (is_wildcard(pattern)) return types.empty() ? Verdict::no : Verdict::yes;
  const bool matched = any_of(
      pattern, [&](const Json& type) { return type.is_object() ? type.contains("@default") : contains(types, type); });
  return matched ? Verdict::yes : Verdict::no;
}

FrameMatcher::Verdict FrameMatcher::match_property(const Json& values, const Json& pattern, bool require_all) const {
  if (pattern.empty()) return values.empty() ? Verdict::yes : Verdict::decides_no;
  const Json& frame = single_frame(pattern);
  if (values.empty() && frame.contains("@default")) return Verdict::skip;
  bool matched = !values.empty();
  if (is_list(frame))
    matched = match_list(values, frame["@list"], require_all);
  else if (is_value(frame))
    matched = any_of(values, [&](const Json& value) { return value_matches(value, frame); });
  else if (is_reference(frame))
    matched = any_of(values, [&](const Json& value) { return match_reference(value, frame, require_all); });
  return matched ? Verdict::yes : Verdict::no;
}

bool FrameMatcher::match_list(const Json& values, const Json& pattern, bool require_all) const {
  if (values.empty() || !is_list(values[0]) || pattern.empty()) return false;
  const Json& items = values[0]["@list"];
  const Json& frame = pattern[0];
  return any_of(items, [&](const Json& item) {
    return is_value(frame) ? is_value(item) && value_matches(item, frame) : match_reference(item, frame, require_all);
  });
}

bool FrameMatcher::match_reference(const Json& value, const Json& pattern, bool require_all) const {
  const auto id = value.find("@id");
  if (id == value.end()) return false;
  const auto node = graph_.find(id->get<std::string>());
  return node != graph_.end() && matches(node->second.json(), pattern, require_all);
}

}  // namespace opal::json_ld
