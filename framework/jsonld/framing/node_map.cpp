// JSON-LD 1.1 API, 7.2.1: Node Map Generation. Numbers in comments are steps of that section.
#include "jsonld/framing/node_map.hpp"

#include <utility>

namespace opal::json_ld {
namespace {

/// What makes two values of one property the same: all but where they stood.
std::string identity(const Json& value) {
  if (!value.is_object() || !value.contains(kPointer)) return value.dump();
  Json bare = value;
  bare.erase(kPointer);
  return bare.dump();
}

/// identity(a) == identity(b), without writing them out.
bool are_same(const Json& a, const Json& b) {
  if (!a.is_object() || !b.is_object()) return a.type() == b.type() && a == b;
  auto x = a.begin();
  auto y = b.begin();
  while (true) {
    while (x != a.end() && x.key() == kPointer) ++x;
    while (y != b.end() && y.key() == kPointer) ++y;
    if (x == a.end() || y == b.end()) return x == a.end() && y == b.end();
    if (x.key() != y.key() || x->type() != y->type() || *x != *y) return false;
    ++x, ++y;
  }
}

void take_index(Node& node, Json& element) {  // 6.8
  const auto index = element.find("@index");
  if (index == element.end()) return;
  Json& known = node.json()["@index"];
  if (!known.is_null() && known != *index)
    throw JsonLdError("conflicting indexes", node.json().value(kPointer, ""),
                      "<" + node.id() + "> has two values of @index");
  known = *index;
  element.erase(index);
}

}  // namespace

Json& Node::values(const std::string& property) {
  Json& result = json_[property];
  if (result.is_null()) result = Json::array();
  return result;
}

void Node::append_once(const std::string& property, Json value) {
  Json& known = values(property);
  // Large arrays (all objects of a building) get an index; it would cost the many small ones too much
  // memory.
  constexpr std::size_t kSmall = 8;
  if (known.size() < kSmall) {
    for (const Json& one : known)
      if (are_same(one, value)) return;
  } else {
    Index& index = index_[property];
    for (; index.known < known.size(); ++index.known) index.values.insert(identity(known[index.known]));
    if (index.values.contains(identity(value))) return;
  }
  known.push_back(std::move(value));
}

void Node::mark(const Json& pointer, bool defines) {
  if (pointer.is_null() || (json_.contains(kPointer) && (defined_ || !defines))) return;
  json_[kPointer] = pointer;
  defined_ = defines;
}

/// What the element being gathered belongs to: nothing, a property of a node, or a list.
struct NodeMap::Owner {
  NodeGraph* graph = nullptr;
  Node* subject = nullptr;
  const std::string* property = nullptr;
  bool reversed = false;  ///< the element points at the subject instead
  Json* list = nullptr;

  /// The owner refers to the node, or the node to the owner.
  void link(Node& node, const Json& pointer) const;
};

void NodeMap::Owner::link(Node& node, const Json& pointer) const {  // 6.5, 6.6
  if (!subject) return;
  Json reference{{"@id", (reversed ? *subject : node).id()}};
  if (!pointer.is_null()) reference[kPointer] = pointer;
  if (list)
    list->push_back(std::move(reference));
  else
    (reversed ? node : *subject).append_once(*property, std::move(reference));
}

void NodeMap::gather(Json& element, const Owner& owner) {
  if (element.is_array()) {
    for (Json& item : element) gather(item, owner);
    return;
  }
  if (element.contains("@type")) relabel_types(element["@type"]);
  if (is_list(element))
    gather_list(element, owner);
  else if (!is_value(element))
    gather_node(element, owner);
  else if (owner.list)
    owner.list->push_back(std::move(element));  // 4
  else if (owner.subject)
    owner.subject->append_once(*owner.property, std::move(element));
}

void NodeMap::relabel_types(Json& types) {  // 3
  if (types.is_string())
    types = blank_nodes_.relabel(types.get<std::string>());
  else if (types.is_array())
    for (Json& type : types) relabel_types(type);
}

void NodeMap::gather_list(Json& list, const Owner& owner) {  // 5
  Json items = Json::array();
  Owner inside = owner;
  inside.list = &items;
  gather(list["@list"], inside);
  Json result{{"@list", std::move(items)}};
  if (owner.list)
    owner.list->push_back(std::move(result));
  else if (owner.subject)
    owner.subject->values(*owner.property).push_back(std::move(result));
}

void NodeMap::gather_node(Json& element, const Owner& owner) {  // 6
  const bool named = element.contains("@id") && element["@id"].is_string();
  const std::string id = named ? blank_nodes_.relabel(element["@id"].get<std::string>()) : blank_nodes_.fresh();
  const Json pointer = element.value(kPointer, Json());
  element.erase("@id");
  element.erase(kPointer);
  Node& node = node_of(*owner.graph, id);
  node.mark(pointer, !element.empty() || !named);
  owner.link(node, pointer);
  if (element.contains("@type"))
    for (Json& type : element["@type"]) node.append_once("@type", std::move(type));
  element.erase("@type");
  take_index(node, element);
  gather_properties(element, node, owner);
}

void NodeMap::gather_reverse(Json& reverse, Node& node, const Owner& owner) {  // 6.9
  for (auto& [property, values] : reverse.items()) {
    Owner inside;
    inside.graph = owner.graph;
    inside.subject = &node;
    inside.property = &property;
    inside.reversed = true;
    gather(values, inside);
  }
}

void NodeMap::gather_properties(Json& element, Node& node, const Owner& owner) {  // 6.9 to 6.12
  Owner inside;
  inside.graph = owner.graph;
  if (element.contains("@reverse")) gather_reverse(element["@reverse"], node, owner);
  if (element.contains("@graph")) {
    Owner graph;
    graph.graph = &graphs_[node.id()];
    gather(element["@graph"], graph);
  }
  if (element.contains("@included")) gather(element["@included"], inside);
  for (const char* done : {"@reverse", "@graph", "@included"}) element.erase(done);
  inside.subject = &node;
  for (auto& [key, values] : element.items()) {
    const std::string property = blank_nodes_.relabel(key);
    inside.property = &property;
    node.values(property);
    gather(values, inside);
  }
}

NodeMap::NodeMap(Json expanded) {
  Owner nobody;
  nobody.graph = &graphs_[kDefaultGraph];
  gather(expanded, nobody);
}

}  // namespace opal::json_ld
