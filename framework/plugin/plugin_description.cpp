#include <opal/plugin/plugin_description.hpp>

#include "common/digest/sha256.hpp"
#include "common/json/json_elements.hpp"
#include "common/phrases.hpp"
#include "plugin/plugin_options.hpp"

#include <opal/common/strict_json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <optional>
#include <set>

namespace opal {
namespace {

using nlohmann::json;

constexpr const char* kContext = "urn:opal:v1";
constexpr std::array<const char*, 7> kKindNames{"FeatureDetector", "PatternTemplate", "HypothesisScorer", "LogSource",
                                                "MapImporter",     "ScanMatcher",     "MapStore"};

std::string shortened(const json& value) {
  const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

/// A value in the document, which knows where it stands.
class Node {
 public:
  Node(const json& value, const std::string& file, std::string pointer = "")
      : value_(value), file_(file), pointer_(std::move(pointer)) {}

  [[noreturn]] void refuse(const std::string& complaint) const {
    throw PluginError(file_ + ": " + (pointer_.empty() ? "/" : pointer_) + ": " + complaint);
  }
  [[noreturn]] void refuse_value(const std::string& expected) const {
    refuse(shortened(value_) + ", expected " + expected);
  }

  const json& value() const { return value_; }

  void expect_object(const std::vector<std::string>& required, const std::vector<std::string>& optional) const {
    if (!value_.is_object()) refuse_value("an object");
    std::vector<std::string> known = required;
    known.insert(known.end(), optional.begin(), optional.end());
    for (const auto& [key, ignored] : value_.items())
      if (std::find(known.begin(), known.end(), key) == known.end())
        refuse("unknown key \"" + key + "\", expected one of: " + listed(known));
    for (const std::string& key : required)
      if (!value_.contains(key)) refuse("the key \"" + key + "\" is missing");
  }

  Node at(const std::string& key) const { return {value_.at(key), file_, pointer_ + "/" + key}; }

  std::optional<Node> find(const std::string& key) const {
    if (!value_.contains(key)) return std::nullopt;
    return at(key);
  }

  std::vector<Node> elements() const {
    if (!value_.is_array()) refuse_value("an array");
    std::vector<Node> nodes;
    for (std::size_t i = 0; i < value_.size(); ++i)
      nodes.emplace_back(value_[i], file_, pointer_ + "/" + std::to_string(i));
    return nodes;
  }

  std::string text() const {
    if (!value_.is_string()) refuse_value("a string");
    return value_.get<std::string>();
  }

  std::string word() const {
    const std::string word = value_.is_string() ? value_.get<std::string>() : "";
    const auto is_space = [](unsigned char c) { return std::isspace(c) != 0; };
    if (word.empty() || std::any_of(word.begin(), word.end(), is_space)) refuse_value("a word without spaces");
    return word;
  }

  /// A name with a prefix, so that names of different makers cannot meet.
  std::string prefixed_name() const {
    const std::string name = word();
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos || colon == 0 || colon + 1 == name.size())
      refuse_value("a name with a prefix, such as \"acme:PostDetector\"");
    return name;
  }

 private:
  const json& value_;
  const std::string& file_;
  std::string pointer_;
};

/// "urn:opal:v1", or an array of it and objects that define further prefixes.
std::map<std::string, std::string> read_prefixes(const Node& context) {
  const json& value = context.value();
  std::map<std::string, std::string> prefixes;
  if (value == kContext) return prefixes;
  if (!value.is_array() || value.empty() || value.front() != kContext)
    context.refuse_value("\"urn:opal:v1\", or an array that begins with it");
  for (std::size_t i = 1; i < value.size(); ++i) {
    const bool are_texts = value[i].is_object() && std::all_of(value[i].begin(), value[i].end(),
                                                               [](const json& iri) { return iri.is_string(); });
    if (!are_texts) context.refuse_value("an object of prefixes after \"urn:opal:v1\"");
    for (const auto& [prefix, iri] : value[i].items()) prefixes[prefix] = iri.get<std::string>();
  }
  return prefixes;
}

PluginKind read_kind(const Node& node) {
  const auto found = std::find(kKindNames.begin(), kKindNames.end(), node.text());
  if (found == kKindNames.end()) node.refuse_value("one of: " + listed(kKindNames));
  return static_cast<PluginKind>(found - kKindNames.begin());
}

std::vector<std::string> read_feature_types(const Node& type, const std::string& key) {
  std::vector<std::string> names;
  if (const auto node = type.find(key))
    for (const Node& element : node->elements()) names.push_back(element.prefixed_name());
  return names;
}

json read_bound(const Node& option, const std::string& key, const OptionInfo& info) {
  const auto bound = option.find(key);
  if (!bound) return nullptr;
  if (info.type != "number" && info.type != "integer") bound->refuse("only numbers and integers have bounds");
  const json& value = bound->value();
  if (info.type == "integer" ? !value.is_number_integer() : !value.is_number())
    bound->refuse_value(info.type == "integer" ? "an integer" : "a number");
  return value;
}

OptionInfo read_option(const Node& node) {
  node.expect_object({"name", "type", "default", "description"}, {"minimum", "maximum", "unit"});
  OptionInfo option;
  option.name = node.at("name").word();
  option.type = node.at("type").text();
  const std::set<std::string> types{"boolean", "integer", "number", "object", "string"};
  if (types.count(option.type) == 0) node.at("type").refuse_value("one of: " + listed(types));
  option.description = node.at("description").text();
  if (const auto unit = node.find("unit")) option.unit = unit->text();
  option.minimum = read_bound(node, "minimum", option);
  option.maximum = read_bound(node, "maximum", option);
  if (!option.minimum.is_null() && !option.maximum.is_null() && option.maximum < option.minimum)
    node.at("maximum").refuse_value("at least the minimum, " + option.minimum.dump());
  option.default_value = node.at("default").value();
  return option;
}

std::vector<OptionInfo> read_options(const Node& type) {
  std::vector<OptionInfo> options;
  const auto list = type.find("options");
  if (!list) return options;
  for (const Node& node : list->elements()) {
    OptionInfo option = read_option(node);
    const auto same_name = [&](const OptionInfo& other) { return other.name == option.name; };
    if (std::any_of(options.begin(), options.end(), same_name)) node.at("name").refuse("is there twice");
    if (!is_acceptable(option, option.default_value)) node.at("default").refuse_value(accepted_values(option));
    options.push_back(std::move(option));
  }
  return options;
}

bool read_on_request(const Node& type, PluginKind kind) {
  const auto node = type.find("on_request");
  if (!node) return false;
  if (kind != PluginKind::pattern_template) node->refuse("only a PatternTemplate can wait to be named");
  if (!node->value().is_boolean()) node->refuse_value("true or false");
  return node->value().get<bool>();
}

DescribedType read_type(const Node& node) {
  node.expect_object({"@id", "kind", "description"}, {"consumes", "produces", "options", "on_request"});
  DescribedType type;
  type.info.name = node.at("@id").prefixed_name();
  type.kind = read_kind(node.at("kind"));
  type.description = node.at("description").text();
  type.info.consumes = read_feature_types(node, "consumes");
  type.info.produces = read_feature_types(node, "produces");
  if (type.kind == PluginKind::feature_detector && type.info.produces.empty())
    node.refuse("a FeatureDetector must say in \"produces\" which feature types it finds");
  type.options = read_options(node);
  type.on_request = read_on_request(node, type.kind);
  return type;
}

std::string text_of(const std::string& path) {
  if (!std::ifstream(path))
    throw PluginError(path + ": cannot be read; every plugin has its description beside it (docs/write_a_plugin.md)");
  return read_json_text(path);
}

}  // namespace

const char* name_of(PluginKind kind) { return kKindNames.at(static_cast<std::size_t>(kind)); }

PluginDescription parse_plugin_description(const json& document, const std::string& file) {
  const Node root(document, file);
  root.expect_object({"@context", "@type", "name", "version", "types"}, {});
  std::map<std::string, std::string> prefixes = read_prefixes(root.at("@context"));
  if (root.at("@type").text() != "Plugin") root.at("@type").refuse_value("\"Plugin\"");
  PluginDescription description{root.at("name").word(), root.at("version").word(), {}, std::move(prefixes)};
  std::set<std::string> names;
  for (const Node& node : root.at("types").elements()) {
    description.types.push_back(read_type(node));
    if (!names.insert(description.types.back().info.name).second) node.at("@id").refuse("is there twice");
  }
  if (description.types.empty()) root.at("types").refuse("is empty, expected at least one type");
  return description;
}

PluginDescription read_plugin_description(const std::string& path) {
  try {
    const std::string text = text_of(path);
    PluginDescription description = parse_plugin_description(parse_json(text, path), path);
    description.sha256 = sha256_of(text);
    return description;
  } catch (const JsonError& error) {
    throw PluginError(error.what());
  }
}

}  // namespace opal
