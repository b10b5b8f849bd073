#pragma once

#include "jsonld/context/iri.hpp"
#include "jsonld/expansion/expansion.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <unordered_set>

namespace opal::json_ld {

inline constexpr const char* kDefaultGraph = "@default";

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

/// One node, as gathered from everywhere in a graph.
class Node {
 public:
  explicit Node(const std::string& id) : id_(id), json_{{"@id", id}} {}

  const std::string& id() const { return id_; }
  Json& json() { return json_; }
  const Json& json() const { return json_; }
  /// The array of a property's values, which is made if absent.
  Json& values(const std::string& property);
  /// Appends the value, unless the property has it already.
  void append_once(const std::string& property, Json value);
  /// The place of a definition is worth more than that of a mere reference.
  void mark(const Json& pointer, bool defines);
  bool is_mere_reference() const { return is_reference(json_); }

 private:
  std::string id_;
  Json json_;
  bool defined_ = false;
  struct Index {
    std::unordered_set<std::string> values;
    std::size_t known = 0;  ///< how many of the property's values are in it
  };
  std::map<std::string, Index> index_;
};

/// The nodes of a graph by @id.
using NodeGraph = std::map<std::string, Node>;

/// Node Map Generation (JSON-LD 1.1 API, 7.2.1): the nodes of every graph of a document, each gathered from wherever it
/// is spoken of. Blank nodes get the labels _:b0, _:b1, ...
class NodeMap {
 public:
  /// @param expanded  an expanded document, which is consumed.
  explicit NodeMap(Json expanded);
  /// By name; the default graph is kDefaultGraph.
  std::map<std::string, NodeGraph>& graphs() { return graphs_; }

 private:
  struct Owner;

  void gather(Json& element, const Owner& owner);
  void relabel_types(Json& types);
  void gather_list(Json& list, const Owner& owner);
  void gather_node(Json& element, const Owner& owner);
  void gather_reverse(Json& reverse, Node& node, const Owner& owner);
  void gather_properties(Json& element, Node& node, const Owner& owner);

  std::map<std::string, NodeGraph> graphs_;
  BlankNodeIssuer blank_nodes_;
};

/// The node of that name, which is made if absent.
inline Node& node_of(NodeGraph& graph, const std::string& id) { return graph.try_emplace(id, id).first->second; }

}  // namespace opal::json_ld
