#include "json_comparison.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace opal::test {
namespace {

using Json = nlohmann::json;
using Labels = std::map<std::string, std::string>;

bool is_blank(const std::string& text) { return text.rfind("_:", 0) == 0; }

void collect_labels(const Json& value, std::set<std::string>& labels) {
  if (value.is_string() && is_blank(value.get<std::string>())) labels.insert(value.get<std::string>());
  if (value.is_object())
    for (const auto& [key, entry] : value.items())
      if (is_blank(key)) labels.insert(key);
  if (value.is_structured())
    for (const Json& entry : value) collect_labels(entry, labels);
}

std::string renamed(const std::string& text, const Labels& labels) {
  const auto found = labels.find(text);
  return found == labels.end() ? text : found->second;
}

/// Language tags are the same whatever their case (BCP 47, 2.1.1).
Json lower_case(const Json& value) {
  if (!value.is_string()) return value;
  std::string text = value;
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// The document with every unordered array sorted and blank nodes renamed.
Json canonical(const Json& value, const Labels& labels, bool ordered) {
  if (value.is_string()) return renamed(value.get<std::string>(), labels);
  if (value.is_object()) {
    Json result = Json::object();
    const bool literal = value.value("@type", Json()) == "@json";
    for (const auto& [key, entry] : value.items())
      result[renamed(key, labels)] = literal              ? entry
                                     : key == "@language" ? lower_case(entry)
                                                          : canonical(entry, labels, key == "@list");
    return result;
  }
  if (!value.is_array()) return value;
  std::vector<Json> items;
  for (const Json& item : value) items.push_back(canonical(item, labels, false));
  if (!ordered) std::sort(items.begin(), items.end());
  return items;
}

/// Refines the label of every blank node by what is said with it, until labels that can be told apart are
/// apart.
Labels signatures(const Json& document) {
  std::set<std::string> names;
  collect_labels(document, names);
  Labels labels;
  for (const std::string& name : names) labels[name] = "_:";
  for (std::size_t round = 0; round <= names.size() && round < 8; ++round) {
    Labels refined;
    std::map<std::string, std::string> short_names;
    for (const std::string& name : names) {
      Labels marked = labels;
      marked[name] += "*";
      short_names[canonical(document, marked, false).dump()];
      refined[name] = canonical(document, marked, false).dump();
    }
    int next = 0;
    for (auto& [signature, short_name] : short_names) short_name = "_:" + std::to_string(next++);
    for (auto& [name, signature] : refined) signature = short_names[signature];
    labels = std::move(refined);
  }
  return labels;
}

}  // namespace

bool same_document(const Json& a, const Json& b) {
  return canonical(a, {}, false) == canonical(b, {}, false) ||
         canonical(a, signatures(a), false) == canonical(b, signatures(b), false);
}

std::string difference(const Json& expected, const Json& found) {
  const Json patch = Json::diff(canonical(expected, {}, false), canonical(found, {}, false));
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(patch.size(), 5); ++i) text += "    " + patch[i].dump() + "\n";
  return text + "    found: " + found.dump().substr(0, 2000) + "\n";
}

}  // namespace opal::test
