#include "cli/plugins/trusted_list.hpp"

#include "common/digest/sha256.hpp"
#include "deployment/class_files.hpp"
#include "deployment/store_source.hpp"
#include "deployment/types_made.hpp"
#include "plugin/described_library.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"
#include "session/stored_maps.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <map>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;

Deployment deployment_of(const TrustedListRequest& request) {
  Deployment deployment = read_deployment(session::config_file(request.config));
  deployment.trusted_plugins.reset();
  if (!request.map.empty()) deployment.map = request.map;
  if (deployment.map.empty())
    throw ConfigError(deployment.file +
                      ": /map: absent, expected a map here or by --map: it decides which plugins run");
  return deployment;
}

/// Of the parts, the map and the log.
std::vector<std::string> types_of(const TrustedListRequest& request, const Deployment& deployment,
                                  const PluginRegistry& registry) {
  std::vector<std::string> types = types_made(deployment, registry, *session::load_map(registry, deployment));
  if (read_store_source(deployment.map))
    types.push_back(session::map_store_type(registry));
  else if (!session::is_map_document(deployment.map))
    types.push_back(session::importer_of(registry, deployment.map).info.name);
  if (!request.log.empty()) types.push_back(session::log_source_of(registry, request.log));
  return types;
}

std::string entry_of_plugin(const std::string& name, const std::string& library) {
  return fmt::format(R"(  {{ "plugin": {}, "sha256": "{}", "description_sha256": "{}" }})", nlohmann::json(name).dump(),
                     sha256_of_file(library), sha256_of_file(description_file(library)));
}

std::string entry_of_file(const std::string& name, const std::string& file) {
  return fmt::format(R"(  {{ "file": {}, "sha256": "{}" }})", nlohmann::json(name).dump(), sha256_of_file(file));
}

}  // namespace

std::string trusted_list(const TrustedListRequest& request) {
  const Deployment deployment = deployment_of(request);
  const PluginRegistry registry = session::load_plugins();
  std::map<std::string, std::string> plugins;
  for (const std::string& type : types_of(request, deployment, registry))
    plugins[registry.type(type).plugin] = registry.type(type).file;
  std::vector<std::string> entries;
  for (const auto& [name, file] : plugins) entries.push_back(entry_of_plugin(name, file));
  const fs::path folder = fs::absolute(deployment.file).parent_path();
  for (const std::string& file : class_files(deployment))
    entries.push_back(entry_of_file(fs::absolute(file).lexically_proximate(folder).string(), file));
  return fmt::format("\"trusted_plugins\": [\n{}\n]\n", fmt::join(entries, ",\n"));
}

}  // namespace opal::cli
