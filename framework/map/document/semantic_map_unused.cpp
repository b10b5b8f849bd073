#include "map/document/semantic_map_unused.hpp"

#include "map/map_vocabulary.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace opal {
namespace {

using nlohmann::json;
using Labels = std::unordered_map<std::string, std::string>;

struct RoleWords {
  std::vector<std::string_view> properties;
  std::vector<std::string_view> types;
};

using namespace vocabulary;

/// In the order of NodeRole.
const std::array<RoleWords, 16>& words_by_role() {
  static const std::array<RoleWords, 16> words{{
      {{iri::kName, iri::kSmear, iri::kCutHeight, iri::kStorey, iri::kWidestDoor, iri::kNorth, iri::kCrs,
        iri::kEastings, iri::kNorthings, iri::kCrsHeight, iri::kCrsHeading},
       {iri::kSemanticMap}},
      {{iri::kRepresentedBy, iri::kName, iri::kSourceClass, iri::kStorey, iri::kThickness, iri::kWidth, iri::kAxis,
        iri::kMergedIds},
       {}},
      {{}, {iri::kElement}},
      {{iri::kRepresentedBy, iri::kHasGeometry, iri::kPerceivableBy, iri::kFeatureType, iri::kPositionSigma,
        iri::kExistence},
       {iri::kRepresentation}},
      {{}, {iri::kSensor}},
      {{iri::kBegin, iri::kEnd}, {iri::kLineSegment}},
      {{iri::kCornerPoint, iri::kHeading, iri::kOpening}, {iri::kCorner}},
      {{iri::kCenter, iri::kRadius}, {iri::kCircle}},
      {{iri::kX, iri::kY}, {iri::kPoint}},
      {{iri::kPositionSigma, iri::kExistence}, {}},
      {{iri::kTemplate, iri::kFeatures, iri::kSubpatterns, iri::kDimensions, iri::kPerceivableBy}, {iri::kPattern}},
      {{iri::kX, iri::kY, iri::kHeading, iri::kScaleX, iri::kScaleY}, {iri::kPlacement}},
      {{iri::kName, iri::kHasStorey}, {iri::kBuilding}},
      {{iri::kName, iri::kX, iri::kY, iri::kLevel}, {iri::kStoreyType}},
      {{iri::kName, iri::kConnectionType, iri::kLandings, iri::kRadius}, {iri::kConnection}},
      {{iri::kOnStorey, iri::kX, iri::kY, iri::kHeading}, {iri::kLanding}},
  }};
  return words;
}

template <class Test>
bool any_role(const NodeUse& use, Test test) {
  const auto& words = words_by_role();
  for (std::size_t role = 0; role < words.size(); ++role)
    if (use.plays(static_cast<NodeRole>(role)) && test(words[role])) return true;
  return false;
}

bool contains(const std::vector<std::string_view>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

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
      if (!is_blank(id)) follow(*node);
    for (const auto& [id, node] : by_id_)
      if (is_blank(id)) (void)label_of(id);
  }
  std::string operator()(const std::string& id) const {
    const auto label = labels_.find(id);
    return label == labels_.end() ? id : label->second;
  }

 private:
  std::string label_of(const std::string& id) {
    if (!is_blank(id)) return id;
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

bool NodeUse::holds_property(std::string_view iri) const {
  return any_role(*this, [iri](const RoleWords& words) { return contains(words.properties, iri); });
}

bool NodeUse::holds_type(std::string_view iri) const {
  if (iri == object_type) return true;
  return any_role(*this, [iri](const RoleWords& words) { return contains(words.types, iri); });
}

std::vector<std::string> NodeUse::properties() const {
  std::vector<std::string> all;
  any_role(*this, [&all](const RoleWords& words) {
    all.insert(all.end(), words.properties.begin(), words.properties.end());
    return false;
  });
  return all;
}

json unused_part(const GraphNode& node, const NodeUse& use) {
  json rest;  // made only when there is something to hold: most nodes are used up
  for (const auto& [key, value] : node.content().items()) {
    if (key == "@type") {
      json types = json::array();
      for (const json& type : value)
        if (!use.holds_type(type.get_ref<const std::string&>())) types.push_back(type);
      if (!types.empty()) rest[key] = std::move(types);
    } else if (key != "@id" && key != "@pointer" && !use.holds_property(key)) {
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
  for (std::size_t i = 0; i < graph.nodes().size(); ++i) {
    json part = unused_part(graph.nodes()[i], uses[i]);
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
