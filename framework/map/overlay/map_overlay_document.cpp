// From overlay documents to MapOverlay.
#include "common/phrases.hpp"
#include "map/overlay/map_overlay.hpp"

#include "map/document/semantic_map_document.hpp"
#include "map/document/semantic_map_graph.hpp"
#include "map/map_vocabulary.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <array>
#include <set>

namespace opal {
namespace {

using namespace vocabulary;
using Words = std::vector<std::string_view>;

constexpr std::array kNumbers{iri::kX,      iri::kY,         iri::kHeading,      iri::kOpening,
                              iri::kRadius, iri::kExistence, iri::kPositionSigma};
constexpr std::array kTypes{iri::kObjectType, iri::kFeatureType};

/// Opal's words on a node are those that mean something there; what other vocabularies say is for people.
void expect_words(const GraphNode& node, const Words& words) {
  for (const auto& [key, value] : node.content().items()) {
    if (!is_own(key) || std::find(words.begin(), words.end(), key) != words.end()) continue;
    node.fail(node.description() + " has " + short_term(key) + ", which means nothing there; expected " +
              listed_by(words, [](std::string_view word) { return short_term(word); }));
  }
}

class OverlayReader {
 public:
  OverlayReader(const nlohmann::json& document, const std::string& source)
      : graph_(flattened_document(document, source, true), source) {
    overlay_.source = source;
    overlay_.prefixes = prefixes_of(document);
  }

  MapOverlay overlay() {
    read_head(head());
    for (const GraphNode& node : graph_.nodes())
      if (!used_.contains(node.id())) add(node);
    return std::move(overlay_);
  }

 private:
  const GraphNode& head() const {
    const GraphNode* found = nullptr;
    for (const GraphNode& node : graph_.nodes()) {
      if (!node.has_type(iri::kOverlay)) continue;
      if (found) node.fail("a second MapOverlay, expected one in a document");
      found = &node;
    }
    if (!found) throw MapError(overlay_.source + ": the document holds no MapOverlay, expected one");
    return *found;
  }

  void read_head(const GraphNode& node) {
    expect_words(node, {iri::kChanges, iri::kBecause, iri::kIfMissing});
    used_.insert(node.id());
    overlay_.name = node.text(iri::kName).value_or("");
    const std::string because = node.text(iri::kBecause).value_or("");
    const bool report = reports_missing(node, false);
    for (const GraphReference& reference : node.references(iri::kChanges))
      read_change(graph_.at(reference, node), because, report);
  }

  static bool reports_missing(const GraphNode& node, bool otherwise) {
    const auto text = node.text(iri::kIfMissing);
    if (text && *text != "refuse" && *text != "report")
      node.fail("if_missing is \"" + *text + "\", expected \"refuse\" or \"report\"");
    return text ? *text == "report" : otherwise;
  }

  std::string name_of(const std::string& id) const { return compact_name(id, overlay_.prefixes); }

  void read_change(const GraphNode& node, const std::string& because, bool report) {
    Words words{iri::kTarget, iri::kPerceivableBy, iri::kNotPerceivableBy, iri::kBecause, iri::kWas, iri::kIfMissing};
    words.insert(words.end(), kNumbers.begin(), kNumbers.end());
    words.insert(words.end(), kTypes.begin(), kTypes.end());
    expect_words(node, words);
    if (!node.types().empty() && !node.has_type(iri::kChange))
      node.fail(node.description() + " is no MapChange, expected one");
    used_.insert(node.id());
    OverlayChange change;
    change.target = name_of(node.required_reference(iri::kTarget).id);
    change.place = overlay_.source + ": " + node.place();
    change.because = node.text(iri::kBecause).value_or(because);
    change.report_if_missing = reports_missing(node, report);
    change.numbers = numbers_of(node);
    for (const std::string_view word : kTypes)
      if (const auto type = node.reference(word)) change.types[short_term(word)] = name_of(type->id);
    for (const GraphReference& sensor : node.references(iri::kPerceivableBy))
      change.perceivable_by.push_back(name_of(sensor.id));
    for (const GraphReference& sensor : node.references(iri::kNotPerceivableBy))
      change.not_perceivable_by.push_back(name_of(sensor.id));
    if (const auto was = node.reference(iri::kWas)) change.was = read_was(graph_.at(*was, node), change);
    expect_something(node, change);
    overlay_.changes.push_back(std::move(change));
  }

  static std::map<std::string, double> numbers_of(const GraphNode& node) {
    std::map<std::string, double> numbers;
    for (const std::string_view word : kNumbers)
      if (const auto number = node.number(word)) numbers[short_term(word)] = *number;
    return numbers;
  }

  std::map<std::string, double> read_was(const GraphNode& node, const OverlayChange& change) {
    expect_words(node, Words(kNumbers.begin(), kNumbers.end()));
    used_.insert(node.id());
    const auto was = numbers_of(node);
    for (const auto& [word, value] : was)
      if (!change.numbers.contains(word)) node.fail("was has " + word + ", expected only what the change sets");
    return was;
  }

  static void expect_something(const GraphNode& node, const OverlayChange& change) {
    if (change.numbers.empty() && change.types.empty() && change.perceivable_by.empty() &&
        change.not_perceivable_by.empty())
      node.fail("the change of '" + change.target +
                "' changes nothing, expected x and y, existence, not_perceivable_by, ...");
  }

  /// What an overlay adds: objects with all that represents them, points, sensors; and what others say of them.
  void add(const GraphNode& node) {
    if (node.has_type(iri::kChange))
      node.fail(node.description() + " belongs to no MapOverlay, expected one whose changes name it");
    for (const std::string_view type : {iri::kSemanticMap, iri::kPattern, iri::kPlacement})
      if (node.has_type(type))
        node.fail("a " + short_term(type) + ", expected objects with their representations, points and sensors");
    overlay_.additions.push_back(node.content());
  }

  Graph graph_;
  MapOverlay overlay_;
  std::set<std::string> used_;
};

}  // namespace

MapOverlay read_overlay(const std::string& path) { return OverlayReader(read_document(path), path).overlay(); }

MapOverlay parse_overlay(const std::string& text, const std::string& name) {
  return OverlayReader(parse_document(text, name), name).overlay();
}

}  // namespace opal
