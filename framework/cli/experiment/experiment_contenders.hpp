#pragma once

#include "cli/experiment/experiments.hpp"
#include "common/phrases.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include "benchmark/experiments/kit/contender.hpp"
#include "simulation/buildings/building.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <filesystem>

namespace opal::cli {

/// Configurations by file, or by name if they ship.
inline std::vector<experiments::Contender> contenders(const std::vector<std::string>& configs) {
  std::vector<experiments::Contender> all;
  for (const std::string& config : configs)
    all.push_back({std::filesystem::path(config).stem().string(), read_deployment(session::config_file(config)), ""});
  return all;
}

/// The map that is asked for, or a building of our own.
inline std::shared_ptr<const SemanticMap> building(const PluginRegistry& registry, const std::string& map,
                                                   const std::string& kind) {
  if (!map.empty()) return session::load_map(registry, map);
  simulation::BuildingRequest request;
  request.kind = kind;
  return simulation::generate_building(request).map;
}

/// The ids of all, those that begin like the one that is asked for first; many are not told.
template <class Named>
std::string some_like(const std::string& id, const std::vector<Named>& all) {
  constexpr std::size_t kMost = 20;
  const auto alike = [&id](const std::string& other) { return std::ranges::mismatch(id, other).in1 - id.begin(); };
  std::vector<std::string> ids;
  for (const Named& one : all) ids.push_back(one.id);
  if (ids.size() > kMost)
    std::ranges::stable_sort(ids, [&](const auto& a, const auto& b) { return alike(a) > alike(b); });
  return listed(ids, "", kMost);
}

/// Those that are asked for. @throws opal::ConfigError naming what there is none of, and some that there are.
template <class Named>
std::vector<Named> chosen(std::vector<Named> all, const std::vector<std::string>& only) {
  if (only.empty()) return all;
  for (const std::string& id : only)
    if (std::none_of(all.begin(), all.end(), [&](const Named& one) { return one.id == id; }))
      throw ConfigError("experiment: none is called '" + id + "', expected some of " + some_like(id, all));
  std::erase_if(all, [&](const Named& one) { return std::find(only.begin(), only.end(), one.id) == only.end(); });
  return all;
}

}  // namespace opal::cli
