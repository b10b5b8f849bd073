// JSON-LD 1.1 API, 7.2: Flattening, and the Node Map Generation that it rests on. Numbers in comments are steps of
// the latter.
#include "json_ld_expansion.hpp"
#include "json_ld_iri.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>

namespace opal::json_ld {
namespace {

const std::string kDefaultGraph = "@default";

/// Hands out _:b0, _:b1, ... in the order of asking: the same document always gets the same labels.
class BlankNodeIssuer {
 public:
  std::string fresh() { return "_:b" + std::to_string(count_++); }
  std::string relabel(const std::string& id) {
    if (!is_blank_node(id)) return id;
    std::string& label = labels_[id];
    if (label.empty()) label = fresh();
    return label;
  }

 private:
  std::map<std::string, std::string> labels_;
  std::size_t count_ = 0;
};

/// What makes two values of one property the same: all but where they stood.
std::string identity(const Json& value) {
  if (!value.is_object() || !value.contains(kPointer)) return value.dump();
  Json bare = value;
  bare.erase(kPointer);
  return bare.dump();
}

/// One node, as gathered from everywhere in the document.
class Node {
 public:
  explicit Node(const std::string& id) : json_{{"@id", id}} {}

  Json& json() { return json_; }
  void touch(const std::string& property) {
    Json& values = json_[property];
    if (values.is_null()) values = Json::array();
  }
  void append(const std::string& property, Json value) {
    touch(property);
    json_[property].push_back(std::move(value));
  }
  void append_once(const std::string& property, Json value) {
    touch(property);
    Json& values = json_[property];
    // Large arrays (all objects of a building) get an index; it would cost the many small ones too much memory.
    constexpr std::size_t kSmall = 8;
    if (values.size() < kSmall) {
      const std::string wanted = identity(value);
      for (const Json& known : values)
        if (identity(known) == wanted) return;
    } else {
      auto& seen = seen_[property];
      if (seen.size() != values.size())
        for (const Json& known : values) seen.insert(identity(known));
      if (!seen.insert(identity(value)).second) return;
    }
    values.push_back(std::move(value));
  }
  /// The place of a definition is worth more than that of a mere reference.
  void mark(const Json& pointer, bool defines) {
    if (pointer.is_null() || (json_.contains(kPointer) && (defined_ || !defines))) return;
    json_[kPointer] = pointer;
    defined_ = defines;
  }
  bool is_mere_reference() const { return json_.size() == (json_.contains(kPointer) ? 2u : 1u); }

 private:
  Json json_;
  bool defined_ = false;
  std::map<std::string, std::unordered_set<std::string>> seen_;
};

using Graph = std::map<std::string, Node>;

/// What the element being gathered belongs to: nothing, a property of a node, or a list.
struct Owner {
  std::string graph = kDefaultGraph;
  std::optional<std::string> subject;  ///< id of the node
  std::string property;
  bool reversed = false;  ///< the element points at the subject instead
  Json* list = nullptr;
};

class NodeMap {
 public:
  void gather(Json& element, const Owner& owner);
  Json flattened();

 private:
  Node& node(const std::string& graph, const std::string& id) { return graphs_[graph].try_emplace(id, id).first->second; }
  void gather_value(Json& value, const Owner& owner);
  void gather_list(Json& list, const Owner& owner);
  void gather_node(Json& element, const Owner& owner);
  void link(const std::string& id, const Json& pointer, const Owner& owner);
  void take_index(Node& target, const std::string& id, Json& element);
  void gather_reverse(Json& reverse, const std::string& id, const Owner& owner);
  void gather_properties(Json& element, const std::string& id, const Owner& owner);
  static Json listed(Graph& graph);

  std::map<std::string, Graph> graphs_;
  BlankNodeIssuer blank_nodes_;
};

void NodeMap::gather(Json& element, const Owner& owner) {
  if (element.is_array()) {
    for (Json& item : element) gather(item, owner);
    return;
  }
  const auto types = element.find("@type");
  if (types != element.end()) {  // 3
    if (types->is_string()) *types = blank_nodes_.relabel(types->get<std::string>());
    else if (types->is_array())
      for (Json& type : *types)
        if (type.is_string()) type = blank_nodes_.relabel(type.get<std::string>());
  }
  if (is_value(element)) gather_value(element, owner);
  else if (is_list(element)) gather_list(element, owner);
  else gather_node(element, owner);
}

void NodeMap::gather_value(Json& value, const Owner& owner) {  // 4
  if (owner.list) owner.list->push_back(std::move(value));
  else if (owner.subject) node(owner.graph, *owner.subject).append_once(owner.property, std::move(value));
}

void NodeMap::gather_list(Json& list, const Owner& owner) {  // 5
  Json items = Json::array();
  Owner inside = owner;
  inside.list = &items;
  gather(list["@list"], inside);
  Json result{{"@list", std::move(items)}};
  if (owner.list) owner.list->push_back(std::move(result));
  else if (owner.subject) node(owner.graph, *owner.subject).append(owner.property, std::move(result));
}

void NodeMap::gather_node(Json& element, const Owner& owner) {  // 6
  const bool named = element.contains("@id") && element["@id"].is_string();
  const std::string id = named ? blank_nodes_.relabel(element["@id"].get<std::string>()) : blank_nodes_.fresh();
  const Json pointer = element.value(kPointer, Json());
  element.erase("@id");
  element.erase(kPointer);
  Node& target = node(owner.graph, id);
  target.mark(pointer, !element.empty() || !named);
  link(id, pointer, owner);
  if (element.contains("@type"))
    for (Json& type : element["@type"]) target.append_once("@type", std::move(type));
  element.erase("@type");
  take_index(target, id, element);
  gather_properties(element, id, owner);
}

void NodeMap::link(const std::string& id, const Json& pointer, const Owner& owner) {  // 6.5, 6.6
  if (!owner.subject) return;
  Json reference{{"@id", owner.reversed ? *owner.subject : id}};
  if (!pointer.is_null()) reference[kPointer] = pointer;
  if (owner.list) owner.list->push_back(std::move(reference));
  else node(owner.graph, owner.reversed ? id : *owner.subject).append_once(owner.property, std::move(reference));
}

void NodeMap::take_index(Node& target, const std::string& id, Json& element) {  // 6.8
  const auto index = element.find("@index");
  if (index == element.end()) return;
  Json& known = target.json()["@index"];
  if (!known.is_null() && known != *index)
    throw JsonLdError("conflicting indexes", target.json().value(kPointer, ""), "<" + id + "> has two values of @index");
  known = *index;
  element.erase(index);
}

void NodeMap::gather_reverse(Json& reverse, const std::string& id, const Owner& owner) {  // 6.9
  for (auto& [property, values] : reverse.items()) {
    Owner inside;
    inside.graph = owner.graph;
    inside.subject = id;
    inside.property = property;
    inside.reversed = true;
    gather(values, inside);
  }
}

void NodeMap::gather_properties(Json& element, const std::string& id, const Owner& owner) {  // 6.9 to 6.12
  Owner inside;
  inside.graph = owner.graph;
  if (element.contains("@reverse")) gather_reverse(element["@reverse"], id, owner);
  if (element.contains("@graph")) {
    Owner graph;
    graph.graph = id;
    graphs_[id];
    gather(element["@graph"], graph);
  }
  if (element.contains("@included")) gather(element["@included"], inside);
  for (const char* done : {"@reverse", "@graph", "@included"}) element.erase(done);
  inside.subject = id;
  for (auto& [property, values] : element.items()) {
    inside.property = blank_nodes_.relabel(property);
    node(owner.graph, id).touch(inside.property);
    gather(values, inside);
  }
}

Json NodeMap::listed(Graph& graph) {
  Json nodes = Json::array();
  for (auto& [id, entry] : graph)
    if (!entry.is_mere_reference()) nodes.push_back(std::move(entry.json()));
  return nodes;
}

Json NodeMap::flattened() {
  for (auto& [name, graph] : graphs_)
    if (name != kDefaultGraph) node(kDefaultGraph, name).json()["@graph"] = listed(graph);
  return listed(graphs_[kDefaultGraph]);
}

}  // namespace

Json flatten(const Json& document, const Options& options) {
  Json expanded = expand(document, options);
  NodeMap nodes;
  nodes.gather(expanded, Owner());
  return nodes.flattened();
}

}  // namespace opal::json_ld
