#include "map/document/semantic_map_graph.hpp"

#include "map/map_vocabulary.hpp"

#include <opal/common/error.hpp>
#include <opal/common/number_text.hpp>

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

using nlohmann::json;
using vocabulary::short_term;

constexpr const char* kPointer = "@pointer";

const json& values_of(const json& node, std::string_view iri) {
  static const json none = json::array();
  const auto found = node.find(iri);
  return found == node.end() ? none : *found;
}

/// What a value object says, as a person would write it.
std::string written(const json& value) {
  if (value.contains("@id")) return std::string("'").append(value["@id"]).append("'");
  const std::string text = value.contains("@value") ? value["@value"].dump() : without_pointers(value).dump();
  return text.size() <= 80 ? text : text.substr(0, 77) + "...";
}

/// Numbers that went through RDF come back as typed text: "1.5E0"^^xsd:double.
std::optional<double> typed_number(const json& value) {
  const std::string type = value.value("@type", "");
  const bool numeric =
      type.ends_with("#double") || type.ends_with("#decimal") || type.ends_with("#integer") || type.ends_with("#float");
  if (!numeric || !type.starts_with("http://www.w3.org/2001/XMLSchema#")) return std::nullopt;
  const auto number = parse_number<double>(value["@value"].get<std::string>());
  return number && std::isfinite(*number) ? number : std::nullopt;
}

}  // namespace

json without_pointers(const json& value) {
  if (value.is_array()) {
    json copy = json::array();
    for (const json& element : value) copy.push_back(without_pointers(element));
    return copy;
  }
  if (!value.is_object()) return value;
  json copy = json::object();
  for (const auto& [key, member] : value.items())  // a JSON literal's content is data, whatever its keys
    if (key != kPointer) copy[key] = key == "@value" ? member : without_pointers(member);
  return copy;
}

GraphNode::GraphNode(const json& node, std::size_t position, const std::string& source)
    : node_(&node),
      id_(node.at("@id").get_ptr<const std::string*>()),
      types_(&values_of(node, "@type")),
      position_(position),
      source_(&source) {}

void GraphNode::fail_at(const std::string& place, const std::string& message) const {
  throw MapError(*source_ + ": " + (place.empty() ? "the document" : place) + ": " + message);
}

void GraphNode::fail_missing(std::string_view iri) const {
  fail(description() + " has no " + short_term(iri) + ", expected one");
}

std::string GraphNode::place_of(const json& value) const {
  if (value.is_object() && value.contains(kPointer)) return value[kPointer];
  return node_->value(kPointer, "");
}

std::string GraphNode::description() const {
  const std::vector<std::string> all = types();
  const std::string what = all.empty() ? "node" : short_term(all.front());
  return vocabulary::is_blank(id()) ? what + " without @id" : what + " '" + vocabulary::compact_name(id()) + "'";
}

std::vector<std::string> GraphNode::types() const {
  std::vector<std::string> types;
  for (const json& type : *types_) types.push_back(type);
  std::sort(types.begin(), types.end());
  return types;
}

bool GraphNode::has_type(std::string_view iri) const {
  return any_type([iri](const std::string& type) { return type == iri; });
}

const json* GraphNode::single_value(std::string_view iri) const {
  const json& values = values_of(*node_, iri);
  for (std::size_t i = 1; i < values.size(); ++i)
    if (without_pointers(values[i]) != without_pointers(values[0]))
      fail_at(place_of(values[i]), description() + " has the values " + written(values[0]) + " and " +
                                       written(values[i]) + " for " + short_term(iri) + ", expected one");
  return values.empty() ? nullptr : &values[0];
}

double GraphNode::number_in(const json& value, std::string_view iri) const {
  const json* plain = value.contains("@value") ? &value["@value"] : nullptr;
  if (plain && plain->is_number() && std::isfinite(plain->get<double>())) return plain->get<double>();
  if (plain && plain->is_string())
    if (const std::optional<double> number = typed_number(value)) return *number;
  fail_at(place_of(value), short_term(iri) + " of " + description() + " is " + written(value) + ", expected a number");
}

std::optional<double> GraphNode::number(std::string_view iri) const {
  const json* value = single_value(iri);
  return value ? std::optional<double>(number_in(*value, iri)) : std::nullopt;
}

double GraphNode::required_number(std::string_view iri) const {
  const std::optional<double> value = number(iri);
  if (!value) fail_missing(iri);
  return *value;
}

std::optional<std::string> GraphNode::text(std::string_view iri) const {
  const json* value = single_value(iri);
  if (!value) return std::nullopt;
  if (!value->contains("@value") || !(*value)["@value"].is_string())
    fail_at(place_of(*value),
            short_term(iri) + " of " + description() + " is " + written(*value) + ", expected a text");
  return (*value)["@value"].get<std::string>();
}

GraphReference GraphNode::reference_in(const json& value, std::string_view iri) const {
  if (!value.contains("@id"))
    fail_at(place_of(value),
            short_term(iri) + " of " + description() + " is " + written(value) + ", expected a node or its @id");
  return {value["@id"], place_of(value)};
}

std::vector<GraphReference> GraphNode::references(std::string_view iri) const {
  std::vector<GraphReference> references;
  for (const json& value : values_of(*node_, iri)) references.push_back(reference_in(value, iri));
  std::stable_sort(references.begin(), references.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  const auto same = [](const auto& a, const auto& b) { return a.id == b.id; };
  references.erase(std::unique(references.begin(), references.end(), same), references.end());
  return references;
}

std::optional<GraphReference> GraphNode::reference(std::string_view iri) const {
  const std::vector<GraphReference> all = references(iri);
  if (all.size() > 1)
    fail_at(all[1].place, description() + " has the values '" + all[0].id + "' and '" + all[1].id + "' for " +
                              short_term(iri) + ", expected one");
  return all.empty() ? std::nullopt : std::optional<GraphReference>(all[0]);
}

GraphReference GraphNode::required_reference(std::string_view iri) const {
  std::optional<GraphReference> found = reference(iri);
  if (!found) fail_missing(iri);
  return *found;
}

const json* GraphNode::single_list(std::string_view iri) const {
  const json* value = single_value(iri);
  if (!value) return nullptr;
  if (!value->contains("@list"))
    fail_at(place_of(*value),
            short_term(iri) + " of " + description() + " is " + written(*value) + ", expected an ordered list (@list)");
  return &(*value)["@list"];
}

std::vector<GraphReference> GraphNode::reference_list(std::string_view iri) const {
  std::vector<GraphReference> references;
  if (const json* list = single_list(iri))
    for (const json& value : *list) references.push_back(reference_in(value, iri));
  return references;
}

std::vector<double> GraphNode::number_list(std::string_view iri) const {
  std::vector<double> numbers;
  if (const json* list = single_list(iri))
    for (const json& value : *list) numbers.push_back(number_in(value, iri));
  return numbers;
}

std::vector<std::string> GraphNode::text_list(std::string_view iri) const {
  std::vector<std::string> texts;
  const json* list = single_list(iri);
  if (!list) return texts;
  for (const json& value : *list) {
    if (!value.contains("@value") || !value["@value"].is_string())
      fail_at(place_of(value),
              short_term(iri) + " of " + description() + " holds " + written(value) + ", expected texts");
    texts.push_back(value["@value"]);
  }
  return texts;
}

Graph::Graph(json flattened, std::string source) : flattened_(std::move(flattened)), source_(std::move(source)) {
  nodes_.reserve(flattened_.size());
  positions_.reserve(flattened_.size());
  for (const json& node : flattened_) {
    nodes_.emplace_back(node, nodes_.size(), source_);
    positions_[nodes_.back().id()] = nodes_.back().position();
    if (node.contains("@graph")) nodes_.back().fail("a named graph, expected all nodes in the document's one graph");
  }
}

const GraphNode* Graph::find(const std::string& id) const {
  const auto found = positions_.find(id);
  return found == positions_.end() ? nullptr : &nodes_[found->second];
}

const GraphNode& Graph::at(const GraphReference& reference, const GraphNode& from) const {
  const GraphNode* node = find(reference.id);
  if (!node)
    from.fail_at(reference.place,
                 from.description() + " refers to '" + reference.id + "', which the document does not define");
  return *node;
}

}  // namespace opal
