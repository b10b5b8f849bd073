#include "patterns/mapped_patterns.hpp"

#include "map/view/support_lines.hpp"
#include "patterns/pattern_cache.hpp"
#include "patterns/pattern_layer.hpp"

#include <opal/common/error.hpp>

namespace opal {
namespace {

MappedPatterns patterns_of_layer(const MapView& map, const std::vector<Named<PatternTemplate>>& templates) {
  MappedPatterns mapped;
  for (const MapFeatureNumber& number : map.features()) mapped.members.add({&number, 1});
  for (const auto& each : templates) mapped.by_template.emplace_back(layer_instances(map, each.name, *each.part));
  return mapped;
}

PatternIndex index_of(const Named<PatternTemplate>& named, std::span<const Feature> features,
                      const PatternCache& cache) {
  try {
    return cache.index_of([&](const PatternCache::Visit& visit) { each_pattern(*named.part, features, visit); },
                          features.size());
  } catch (const PluginError& error) {
    throw PluginError(named.name + ": " + error.what());
  }
}

MappedPatterns all_patterns(const MapView& map, const std::vector<Named<PatternTemplate>>& templates) {
  MappedPatterns mapped;
  std::vector<Feature> features;
  for (MappedFeature& member : mapped_features(map.map(), map.features())) {
    mapped.members.add(member.numbers);
    features.push_back(std::move(member.feature));
  }
  mapped.members.shrink_to_fit();
  const PatternCache cache(map.kept_in());
  for (const auto& each : templates) mapped.by_template.push_back(index_of(each, features, cache));
  return mapped;
}

}  // namespace

MappedPatterns mapped_patterns(const MapView& map, const std::vector<Named<PatternTemplate>>& templates) {
  return has_pattern_layer(map) ? patterns_of_layer(map, templates) : all_patterns(map, templates);
}

}  // namespace opal
