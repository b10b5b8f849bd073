#include "navigation/node_registry.hpp"

#include "common/phrases.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <set>

namespace opal::navigation {
namespace {

std::vector<ConfigObject> trees_of(ConfigObject& document) {
  document.expect_type("opal:BehaviourTrees");
  document.text("comment", "");
  const auto trees = document.list("trees");
  if (!trees || trees->empty()) document.refuse("trees", "a list of at least one tree");
  document.expect_no_more();
  return *trees;
}

/// Makes every tree, so that a mistake in one that is not asked for is found, too.
std::unique_ptr<Node> read(const NodeRegistry& registry, const nlohmann::json& json, const std::string& file,
                           const std::string& wanted) {
  ConfigObject document(json, file);
  std::unique_ptr<Node> chosen;
  std::set<std::string> names;
  for (ConfigObject tree : trees_of(document)) {
    const std::string name = tree.required_text("name");
    tree.text("comment", "");
    if (!names.insert(name).second) tree.refuse("name", "a name that no other tree has");
    auto root = tree.object("root");
    if (!root) tree.refuse("root", "a node");
    tree.expect_no_more();
    std::unique_ptr<Node> made = registry.make(*root);
    if (!chosen && (wanted.empty() || wanted == name)) chosen = std::move(made);
  }
  if (chosen) return chosen;
  throw ConfigError(file + ": /trees: no tree is called '" + wanted + "', expected one of: " + listed(names));
}

}  // namespace

std::string NodeRegistry::names() const {
  return listed_by(types_, [](const auto& named) { return named.first; });
}

void NodeRegistry::wrap(const std::string& type, Around around) {
  const auto found = types_.find(type);
  if (found == types_.end()) throw ConfigError("no node is called '" + type + "', expected one of: " + names());
  found->second.factory = [made = found->second.factory, around = std::move(around)](ConfigObject& options,
                                                                                     Children children) {
    return around(made(options, std::move(children)));
  };
}

Children NodeRegistry::make_children(ConfigObject& description, Arity arity) const {
  Children children;
  if (arity == Arity::none) return children;
  const auto list = description.list("children");
  if (!list || list->empty()) description.refuse("children", "a list of at least one node");
  if (arity == Arity::one && list->size() != 1) description.refuse("children", "a list of one node");
  for (const ConfigObject& child : *list) children.push_back(make(child));
  return children;
}

std::unique_ptr<Node> NodeRegistry::make(ConfigObject description) const {
  const std::string type = description.required_text("@type");
  const auto found = types_.find(type);
  if (found == types_.end()) description.refuse("@type", "one of: " + names());
  description.text("comment", "");
  Children children = make_children(description, found->second.arity);
  static const nlohmann::json none = nlohmann::json::object();
  auto given = description.object("options");
  ConfigObject options = given ? *given : ConfigObject(none, description.where("options"));
  std::unique_ptr<Node> node = found->second.factory(options, std::move(children));
  options.expect_no_more();
  description.expect_no_more();
  return node;
}

std::unique_ptr<Node> read_tree(const NodeRegistry& registry, const std::string& path, const std::string& name) {
  return read(registry, read_json(path), path, name);
}

std::string first_tree(const std::string& path) {
  const nlohmann::json json = read_json(path);
  ConfigObject document(json, path);
  return trees_of(document).front().required_text("name");
}

std::unique_ptr<Node> parse_tree(const NodeRegistry& registry, const std::string& text, const std::string& file,
                                 const std::string& name) {
  return read(registry, parse_json(text, file), file, name);
}

}  // namespace opal::navigation
