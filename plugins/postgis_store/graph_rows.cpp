#include "graph_rows.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <unordered_map>

namespace opal::postgis_store {
namespace {

using nlohmann::json;

bool is_reference(const json& value) { return value.is_object() && value.size() == 1 && value.contains("@id"); }

/// Keys whose values are ids by the context of Opal: written as references, so that they are edges for SQL, too.
bool names_nodes(const std::string& key) { return key == "features" || key == "subpatterns"; }

/// In one array, each value once.
json united(const json& a, const json& b) {
  json all = a.is_array() ? a : json::array({a});
  for (const json& value : b.is_array() ? b : json::array({b}))
    if (std::find(all.begin(), all.end(), value) == all.end()) all.push_back(value);
  return all;
}

/// Takes nodes out of the nodes that hold them.
class Flattening {
 public:
  /// @return the reference to it.
  json add_nested(const json& node) {
    if (is_reference(node)) return node;
    json flat = json::object();
    flat["@id"] = node.contains("@id") ? node["@id"] : json(fmt::format("_:r{}", ++nameless_));
    for (const auto& [key, value] : node.items())
      if (key != "@id") flat[key] = key == "@type" ? value : flattened(value, names_nodes(key));
    json reference = {{"@id", flat["@id"]}};
    place(std::move(flat));
    return reference;
  }

  /// A node that is flat already, in expanded form. Joins the one of the same id, if each says something else.
  void add_flat(const json& node) {
    const auto known = positions_.find(node.at("@id").get<std::string>());
    if (known == positions_.end()) return place(node);
    json& there = nodes_[known->second];
    for (const auto& [key, value] : node.items())
      if (key != "@id" && key != "@type" && there.contains(key)) return nodes_.push_back(node);
    for (const auto& [key, value] : node.items())
      if (key != "@id") there[key] = key == "@type" && there.contains(key) ? united(there[key], value) : value;
  }

  std::vector<std::string> texts() const {
    std::vector<std::string> texts;
    texts.reserve(nodes_.size());
    for (const json& node : nodes_) texts.push_back(node.dump());
    return texts;
  }

 private:
  json flattened(const json& value, bool strings_are_ids) {
    if (value.is_object()) return add_nested(value);
    if (value.is_string() && strings_are_ids) return {{"@id", value}};
    if (!value.is_array()) return value;
    json all = json::array();
    for (const json& element : value) all.push_back(flattened(element, strings_are_ids));
    return all;
  }

  void place(json node) {
    positions_.emplace(node.at("@id").get<std::string>(), nodes_.size());
    nodes_.push_back(std::move(node));
  }

  std::vector<json> nodes_;
  std::unordered_map<std::string, std::size_t> positions_;
  int nameless_ = 0;
};

}  // namespace

GraphRows graph_rows(const SemanticMap& map) {
  const json document = map.to_json_ld();
  const std::size_t own = document["@graph"].size() - map.unused().size();  // the writer puts the unused last
  Flattening flattening;
  for (std::size_t k = 0; k < document["@graph"].size(); ++k)
    if (const json& node = document["@graph"][k]; k < own)
      flattening.add_nested(node);
    else
      flattening.add_flat(node);
  return {document["@context"].dump(), flattening.texts()};
}

}  // namespace opal::postgis_store
