#include "patterns/mapped_patterns.hpp"

#include "map/view/support_lines.hpp"
#include "patterns/pattern_layer.hpp"

namespace opal {
namespace {

MappedPatterns patterns_of_layer(const MapView& map, const std::vector<Named<PatternTemplate>>& templates) {
  MappedPatterns mapped;
  for (const MapFeatureNumber& number : map.features()) mapped.members.add({&number, 1});
  for (const auto& each : templates) mapped.by_template.emplace_back(layer_instances(map, each.name, *each.part));
  return mapped;
}

MappedPatterns all_patterns(const MapView& map, const std::vector<Named<PatternTemplate>>& templates) {
  MappedPatterns mapped;
  std::vector<Feature> features;
  for (MappedFeature& member : mapped_features(map.map(), map.features())) {
    mapped.members.add(member.numbers);
    features.push_back(std::move(member.feature));
  }
  for (const auto& each : templates) {
    PatternTable table;
    each_pattern(*each.part, features, [&table](const PatternInstance& pattern) { table.add(pattern); });
    mapped.by_template.emplace_back(std::move(table));
  }
  return mapped;
}

}  // namespace

MappedPatterns mapped_patterns(const MapView& map, const std::vector<Named<PatternTemplate>>& templates) {
  return has_pattern_layer(map) ? patterns_of_layer(map, templates) : all_patterns(map, templates);
}

}  // namespace opal
