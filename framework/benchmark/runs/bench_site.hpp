#pragma once

#include "map_tools/test_maps/map_damage.hpp"

#include <opal/plugin/plugin_registry.hpp>
#include "map_tools/map_join.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal::benchmark {

/// A recorded place, and the map that its queries run on.
struct BenchSite {
  std::string prefix;  ///< of its files: "sites/acapulco"
  std::string name;    ///< "acapulco"
  std::shared_ptr<const opal::SemanticMap> map;
  opal::Pose2 T_map_site;  ///< of the site's own map in `map`
  double import_s = 0;
};

/// The semantic map PREFIX.map.jsonld, or one made of the grid PREFIX.map.yaml: as it is, but for what is done to
/// grids.
/// @param prefix  of the map's file; usually that of the recording, beside which it stands.
std::shared_ptr<const opal::SemanticMap> site_map(const opal::PluginRegistry& registry, const std::string& prefix,
                                                  const opal::MapDamage& damage);

/// Which maps recorded places are run on.
struct SiteMaps {
  std::string folder;  ///< has a map per place, NAME.map.yaml or .jsonld; empty: beside the recordings
  std::optional<opal::MapDamage> damage;  ///< done to each
};

/// Imports the map of every place and makes it worse as asked. @throws opal::ConfigError if two have the same name.
std::vector<BenchSite> load_sites(const opal::PluginRegistry& registry, const std::vector<std::string>& prefixes,
                                  const SiteMaps& maps);

/// Puts the maps of all places side by side: each place's queries then run on all of them together.
void join_sites(std::vector<BenchSite>& sites, const opal::MapJoin& join);

}  // namespace opal::benchmark
