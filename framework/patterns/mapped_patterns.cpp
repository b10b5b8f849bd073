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

PatternTable table_of(const Named<PatternTemplate>& each, std::span<const Feature> features) {
  PatternTable table;
  try {
    each_pattern(*each.part, features, [&table](const PatternInstance& pattern) { table.add(pattern); });
  } catch (const PluginError& error) {
    throw PluginError(each.name + ": " + error.what());
  }
  return table;
}

MappedPatterns all_patterns(const MapView& map, const std::vector<Named<PatternTemplate>>& templates) {
  MappedPatterns mapped;
  std::vector<Feature> features;
  for (MappedFeature& member : mapped_features(map.map(), map.features())) {
    mapped.members.add(member.numbers);
    features.push_back(std::move(member.feature));
  }
  for (const auto& each : templates) {
    mapped.by_template.emplace_back(table_of(each, features));
  }
  return mapped;
}

}  // namespace

MappedPatterns mapped_patterns(const MapView& map, const std::vector<Named<PatternTemplate>>& templates) {
  return has_pattern_layer(map) ? patterns_of_layer(map, templates) : all_patterns(map, templates);
}

}  // namespace opal
