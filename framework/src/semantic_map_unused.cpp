#include "semantic_map_unused.hpp"

#include "map_vocabulary.hpp"

#include <algorithm>
#include <map>

namespace opal {
namespace {

using nlohmann::json;
using Labels = std::unordered_map<std::string, std::string>;

/// Applies `rename` to each id in an expanded node or value, types included, in a fixed order.
template <class Rename>
void rename_ids(json& value, Rename& rename) {
  if (value.is_array())
    for (json& element : value) rename_ids(element, rename);
  if (!value.is_object()) return;
  for (auto& [key, member] : value.items()) {
    if (key == "@id" || (key == "@type" && member.is_string()))
      member = rename(std::string(member));
    else if (key == "@type")
      for (json& type : member) type = rename(std::string(type));
    else if (key != "@value")
      rename_ids(member, rename);
  }
}

/// Values of a property are a set: any order means the same, so one order is chosen.
void sort_sets(json& node) {
  for (auto& [key, values] : node.items())
    if (values.is_array()) std::sort(values.begin(), values.end());
}

/// Gives blank nodes the labels _:u0, _:u1, ... in the order in which a walk from the named nodes meets them.
class BlankLabels {
 public:
  explicit BlankLabels(const std::vector<json>& nodes) {
    for (const json& node : nodes) by_id_[node["@id"]] = &node;
    for (const auto& [id, node] : by_id_)
      if (!vocabulary::is_blank(id)) follow(*node);
    for (const auto& [id, node] : by_id_)
      if (vocabulary::is_blank(id)) (void)label_of(id);
  }
  std::string operator()(const std::string& id) const {
    const auto label = labels_.find(id);
    return label == labels_.end() ? id : label->second;
  }

 private:
  std::string label_of(const std::string& id) {
    if (!vocabulary::is_blank(id)) return id;
    const auto [entry, is_new] = labels_.try_emplace(id, "_:u" + std::to_string(labels_.size()));
    if (is_new) waiting_.push_back(id);
    return entry->second;
  }
  void follow(const json& node) {
    auto visit = [this](const std::string& id) { return label_of(id), id; };
    json copy = node;
    rename_ids(copy, visit);
    while (!waiting_.empty()) {
      const auto next = by_id_.find(waiting_.back());
      waiting_.pop_back();
      if (next == by_id_.end()) continue;
      json next_copy = *next->second;
      rename_ids(next_copy, visit);
    }
  }

  std::map<std::string, const json*> by_id_;
  Labels labels_;
  std::vector<std::string> waiting_;
};

}  // namespace

json unused_part(const GraphNode& node, const NodeUses& uses) {
  const auto found = uses.find(node.id());
  static const NodeUse none;
  const NodeUse& use = found == uses.end() ? none : found->second;
  json rest = json::object();
  for (const auto& [key, value] : node.content().items()) {
    if (key == "@type") {
      json types = json::array();
      for (const json& type : value)
        if (!use.types.contains(type)) types.push_back(type);
      if (!types.empty()) rest[key] = std::move(types);
    } else if (key != "@id" && key != "@pointer" && !use.properties.contains(key)) {
      rest[key] = without_pointers(value);
    }
  }
  if (rest.empty()) return nullptr;
  rest["@id"] = node.id();
  return rest;
}

json unused_parts(const Graph& graph, const NodeUses& uses, const Labels& names) {
  auto name_of = [&names](const std::string& id) {
    const auto name = names.find(id);
    return name == names.end() ? id : name->second;
  };
  std::vector<json> nodes;
  for (const GraphNode& node : graph.nodes()) {
    json part = unused_part(node, uses);
    if (part.is_null()) continue;
    rename_ids(part, name_of);
    sort_sets(part);
    nodes.push_back(std::move(part));
  }
  BlankLabels labels(nodes);
  for (json& node : nodes) {
    rename_ids(node, labels);
    sort_sets(node);
  }
  std::sort(nodes.begin(), nodes.end(), [](const json& a, const json& b) { return a["@id"] < b["@id"]; });
  return nodes;
}

}  // namespace opal
