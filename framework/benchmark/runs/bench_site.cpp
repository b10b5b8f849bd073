#include "benchmark/runs/bench_site.hpp"

#include "session/session.hpp"

#include <opal/common/error.hpp>
#include "common/stage_clock.hpp"

#include <algorithm>
#include <filesystem>

namespace opal::benchmark {

std::shared_ptr<const opal::SemanticMap> site_map(const opal::PluginRegistry& registry, const std::string& prefix,
                                                  const opal::MapDamage& damage) {
  const std::string document = prefix + ".map.jsonld";
  if (damage.thick_m == 0 && std::filesystem::exists(document)) return opal::SemanticMap::read(document);
  if (!std::filesystem::exists(prefix + ".map.yaml"))
    throw opal::MapError(document + " and " + prefix +
                         ".map.yaml do not exist, expected the prefix of a recorded place");
  return session::import_map(registry, prefix + ".map.yaml", session::import_options(damage)).map;
}

std::vector<BenchSite> load_sites(const opal::PluginRegistry& registry, const std::vector<std::string>& prefixes,
                                  const SiteMaps& maps) {
  std::vector<BenchSite> sites;
  for (const std::string& prefix : prefixes) {
    const std::string name = std::filesystem::path(prefix).filename().string();
    if (std::any_of(sites.begin(), sites.end(), [&](const BenchSite& site) { return site.name == name; }))
      throw opal::ConfigError("bench: two places are called '" + name + "', expected a name for each");
    const double start_s = opal::process_cpu_s();
    const std::string map_prefix = maps.folder.empty() ? prefix : (std::filesystem::path(maps.folder) / name).string();
    auto map = site_map(registry, map_prefix, maps.damage.value_or(opal::MapDamage()));
    const double import_s = opal::process_cpu_s() - start_s;
    if (maps.damage) map = opal::damaged_map(*map, *maps.damage);
    sites.push_back({prefix, name, std::move(map), opal::Pose2(), import_s});
  }
  return sites;
}

void join_sites(std::vector<BenchSite>& sites, const opal::MapJoin& join) {
  std::vector<opal::MapSourcePart> sources;
  for (const BenchSite& site : sites) sources.push_back({site.name, site.map});
  const auto joined = opal::joined_map(sources, join);
  for (BenchSite& site : sites) {
    site.map = joined;
    site.T_map_site = opal::placement_of(*joined, site.name).T_map_source;
  }
}

}  // namespace opal::benchmark
