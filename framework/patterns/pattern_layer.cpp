#include "patterns/pattern_layer.hpp"

#include "common/phrases.hpp"
#include "patterns/neighbour_sight.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace opal {
namespace {

/// Instances of one template; members are positions in MapView::features().
struct TemplatePatterns {
  std::string name;
  std::vector<PatternInstance> instances;
  std::set<GeometryKind> kinds;
};

/// All perceivable features, as templates take them.
std::vector<Feature> perceivable_features(const MapView& map) {
  std::vector<Feature> features;
  for (const MapFeatureNumber number : map.features())
    features.push_back({map.feature(number).type, map.feature(number).geometry});
  return features;
}

bool are_neighbours(const MapView& map, const PatternInstance& instance, double size_m) {
  for (std::size_t k = 1; k < instance.members.size(); ++k) {
    const MapFeatureNumber a = map.features()[instance.members[k - 1]], b = map.features()[instance.members[k]];
    if (connecting_line(map.feature(a).geometry, map.feature(b).geometry).length_m() > size_m) return false;
    if (!see_each_other(map, a, b)) return false;
  }
  return true;
}

TemplatePatterns neighbouring(const MapView& map, std::span<const Feature> features, const Named<PatternTemplate>& each,
                              double size_m) {
  const PatternShape shape = each.part->shape();
  TemplatePatterns found{each.name, find_patterns(*each.part, features), {shape.slots.begin(), shape.slots.end()}};
  std::erase_if(found.instances, [&](const PatternInstance& i) { return !are_neighbours(map, i, size_m); });
  return found;
}

/// Names that no pattern, object or feature of the map has.
class PatternNames {
 public:
  explicit PatternNames(const SemanticMap& map) {
    for (const MapObject& object : map.objects()) taken_.insert(object.id);
    for (const MapFeature& feature : map.features()) {
      taken_.insert({feature.id, feature.representation, feature.sensor});
      taken_.insert(feature.points.begin(), feature.points.end());
    }
  }
  /// "Binary-12" for opal:ColumnPair.
  std::string next(const std::string& pattern_template) {
    const std::string stem = pattern_template.substr(pattern_template.find_last_of(":/#") + 1) + "-";
    std::string name;
    do name = stem + std::to_string(++counts_[stem]);
    while (!taken_.insert(name).second);
    return name;
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> counts_;
};

/// Pairs of neighbours, with the pattern over just these two.
using Pairs = std::map<std::pair<int, int>, std::string>;

std::vector<std::string> subpatterns_of(const PatternInstance& instance, const Pairs& pairs) {
  std::vector<std::string> parts;
  if (instance.members.size() < 3) return parts;
  for (std::size_t k = 1; k < instance.members.size(); ++k) {
    const auto found = pairs.find(std::minmax(instance.members[k - 1], instance.members[k]));
    if (found != pairs.end()) parts.push_back(found->second);
  }
  return parts;
}

void add_patterns(const MapView& map, const TemplatePatterns& found, PatternNames& names, Pairs& pairs,
                  PatternLayer& layer) {
  for (const PatternInstance& instance : found.instances) {
    MapPattern pattern{names.next(found.name), found.name, {}, subpatterns_of(instance, pairs)};
    for (const int member : instance.members) pattern.features.push_back(map.features()[member]);
    for (const Invariant& invariant : instance.invariants) pattern.dimensions.push_back(invariant.value);
    if (instance.members.size() == 2)
      pairs.try_emplace(std::minmax(instance.members[0], instance.members[1]), pattern.id);
    layer.patterns.push_back(std::move(pattern));
  }
}

void add_uniqueness(const MapView& map, const TemplatePatterns& found, PatternLayer& layer) {
  PatternSummary summary{found.name, static_cast<int>(found.instances.size())};
  const PatternIndex index(found.instances);
  std::vector<int> alike;
  std::set<int> members;
  for (const PatternInstance& instance : found.instances) {
    alike.push_back(static_cast<int>(index.count(instance, found.instances.size())) - 1);
    members.insert(instance.members.begin(), instance.members.end());
  }
  layer.alike.insert(layer.alike.end(), alike.begin(), alike.end());
  std::sort(alike.begin(), alike.end());
  if (!alike.empty()) {
    summary.unique = static_cast<int>(std::count(alike.begin(), alike.end(), 0));
    summary.median_alike = alike[(alike.size() - 1) / 2];
    summary.most_alike = alike.back();
  }
  summary.members = static_cast<int>(members.size());
  for (const MapFeatureNumber number : map.features())
    summary.candidates += found.kinds.contains(kind_of(map.feature(number).geometry));
  layer.summaries.push_back(summary);
}

}  // namespace

PatternLayer find_pattern_layer(const MapView& map, const std::vector<Named<PatternTemplate>>& templates,
                                const PatternLayerOptions& options) {
  const std::vector<Feature> features = perceivable_features(map);
  std::vector<TemplatePatterns> found;
  for (const auto& each : templates) found.push_back(neighbouring(map, features, each, options.size_m));
  const auto arity = [](const TemplatePatterns& t) {
    return t.instances.empty() ? 0 : t.instances.front().members.size();
  };
  std::stable_sort(found.begin(), found.end(), [&](const auto& a, const auto& b) { return arity(a) < arity(b); });
  PatternLayer layer;
  PatternNames names(map.map());
  Pairs pairs;
  for (const TemplatePatterns& each : found) {
    add_patterns(map, each, names, pairs, layer);
    add_uniqueness(map, each, layer);
  }
  return layer;
}

PatternLayer read_pattern_layer(const MapView& map, const std::vector<Named<PatternTemplate>>& templates) {
  PatternLayer layer;
  for (const auto& each : templates) {
    const PatternShape shape = each.part->shape();
    add_uniqueness(
        map, {each.name, layer_instances(map, each.name, *each.part), {shape.slots.begin(), shape.slots.end()}}, layer);
    for (const MapPattern& pattern : map.map().patterns())
      if (pattern.pattern_template == each.name && is_for_sensor(map, pattern)) layer.patterns.push_back(pattern);
  }
  return layer;
}

std::string sentence_of(const PatternSummary& s) {
  if (s.patterns == 0)
    return s.pattern_template + ": no pattern among " + count_of(s.candidates, "feature") + " of its shapes";
  return s.pattern_template + ": " + count_of(s.patterns, "pattern") + ", " + std::to_string(s.unique) +
         " unique; half have at most " + count_of(s.median_alike, "look-alike") + ", the worst " +
         std::to_string(s.most_alike) + "; " + std::to_string(s.members) + " of " + count_of(s.candidates, "feature") +
         " of its shapes are in one";
}

}  // namespace opal
