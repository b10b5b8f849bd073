#pragma once

#include <opal/plugin/plugin_registry.hpp>

#include <catch2/catch.hpp>

#include <memory>
#include <string>
#include <vector>

/// A scorer as deployments load it.
inline std::shared_ptr<const opal::HypothesisScorer> scorer_of(const std::string& plugin, const std::string& type,
                                                               const nlohmann::json& options) {
  opal::PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/" + plugin + ".so");
  return registry.make<opal::HypothesisScorer>(type, options);
}

struct Thing {
  std::string type;
  opal::Geometry geometry;
  double position_sigma_m = 0;
  double existence = 1;
};

inline opal::MapView map_of(const std::vector<Thing>& things) {
  std::vector<opal::MapObject> objects;
  std::vector<opal::MapFeature> features;
  for (const Thing& thing : things) {
    const std::string id = "thing-" + std::to_string(objects.size());
    opal::MapFeature feature;
    feature.id = id + "-shape";
    feature.object = opal::MapObjectNumber(objects.size());
    feature.sensor = "lidar";
    feature.geometry = thing.geometry;
    feature.position_sigma_m = thing.position_sigma_m;
    feature.existence = thing.existence;
    objects.push_back({id, thing.type});
    features.push_back(feature);
  }
  return {opal::SemanticMap::make("room", objects, features), "lidar"};
}

inline const opal::LocalMap& no_local_map() {
  static const opal::LocalMap map(opal::LocalMapOptions{}, nullptr);
  return map;
}

inline opal::Hypothesis at(const opal::Pose2& T_map_base) {
  opal::Hypothesis hypothesis;
  hypothesis.T_map_local = T_map_base;
  return hypothesis;
}
