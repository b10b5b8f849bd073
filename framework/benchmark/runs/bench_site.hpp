#pragma once

#include "map_tools/map_damage.hpp"

#include <opal/plugin/plugin_registry.hpp>
#include "map_tools/map_join.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// A recorded place, and the map that its queries run on.
struct BenchSite {
  std::string prefix;  ///< of its files: "sites/acapulco"
  std::string name;    ///< "acapulco"
  std::shared_ptr<const opal::SemanticMap> map;
  opal::Pose2 T_map_site;  ///< of the site's own map in `map`
  double import_s = 0;
};

/// The semantic map that stands beside a recording, or one made of its grid: as it is, but for what is done to grids.
std::shared_ptr<const opal::SemanticMap> site_map(const opal::PluginRegistry& registry, const std::string& prefix,
                                                  const opal::MapDamage& damage);

/// Imports the map of every place and makes it worse as asked. @throws opal::ConfigError if two have the same name.
std::vector<BenchSite> load_sites(const opal::PluginRegistry& registry, const std::vector<std::string>& prefixes,
                                  const std::optional<opal::MapDamage>& damage);

/// Puts the maps of all places side by side: each place's queries then run on all of them together.
void join_sites(std::vector<BenchSite>& sites, const opal::MapJoin& join);
