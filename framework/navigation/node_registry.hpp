#pragma once

#include "navigation/node.hpp"

#include "common/json/config_object.hpp"

#include <functional>
#include <map>

namespace opal::navigation {

/// Node types by name.
class NodeRegistry {
 public:
  /// How many children a node has.
  enum class Arity { none, one, some };
  /// Makes a node. @param options  its "options", read strictly; what is not asked for is an error.
  using Factory = std::function<std::unique_ptr<Node>(ConfigObject& options, Children children)>;

  /// A name that is there already is replaced.
  void add(const std::string& type, Arity arity, Factory factory) { types_[type] = {arity, std::move(factory)}; }

  using Around = std::function<std::unique_ptr<Node>(std::unique_ptr<Node>)>;
  /// Puts something around each node of a type that is made from here on, e.g. to see when it runs.
  /// @throws ConfigError if there is no such type.
  void wrap(const std::string& type, Around around);

  /// Makes the node that an object describes, and what is below it.
  /// @throws ConfigError naming file and place for unknown types, keys, options, and numbers of children.
  std::unique_ptr<Node> make(ConfigObject description) const;

 private:
  struct Type {
    Arity arity;
    Factory factory;
  };
  Children make_children(ConfigObject& description, Arity arity) const;
  std::string names() const;

  std::map<std::string, Type> types_;
};

/// opal:Sequence, opal:Rotate and so on: docs/drive.md lists them.
NodeRegistry standard_nodes();

/// Reads one tree of a document (configs/behaviours.jsonld).
/// @param name  of the tree; empty: the first one.
/// @throws ConfigError naming file and place, also if there is no such tree; JsonError for text that is no JSON.
std::unique_ptr<Node> read_tree(const NodeRegistry& registry, const std::string& path, const std::string& name = "");
/// What the first tree of a document is called. @throws as read_tree.
std::string first_tree(const std::string& path);
/// @param file  what messages call the document.
std::unique_ptr<Node> parse_tree(const NodeRegistry& registry, const std::string& text, const std::string& file,
                                 const std::string& name = "");

}  // namespace opal::navigation
