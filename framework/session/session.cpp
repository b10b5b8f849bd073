#include "session/session.hpp"

#include "common/phrases.hpp"
#include "session/foreign_file.hpp"
#include "session/overlays.hpp"

#include <opal/common/error.hpp>
#include <opal/common/warning.hpp>
#include <opal/plugin/plugin_description.hpp>
#include <opal/plugin/plugin_folders.hpp>

#include <algorithm>
#include <filesystem>
#include <set>

namespace opal::session {
namespace {

namespace fs = std::filesystem;

void tell_refusal(const std::string& refusal) { opal::warn("plugin refused: " + refusal); }

/// A plugin that cannot be used recognizes nothing, and does not stand in the way of the others.
template <class T>
bool recognizes(const opal::PluginRegistry& registry, const std::string& type, const std::string& path) {
  std::shared_ptr<const T> reader;
  try {
    reader = registry.make<T>(type);
  } catch (const opal::PluginError& refusal) {
    tell_refusal(refusal.what());
  }
  return reader != nullptr && reader->recognizes(path);
}

/// Name of the type of this kind that recognizes the source; empty if none does.
template <class T>
std::string recognizing(const opal::PluginRegistry& registry, opal::PluginKind kind, const std::string& path,
                        const std::string& other_than = "") {
  for (const opal::RegisteredType& type : registry.types())
    if (type.kind == kind && type.info.name != other_than && registry.is_listed(type.info.name) &&
        recognizes<T>(registry, type.info.name, path))
      return type.info.name;
  return "";
}

/// A line for every plugin of a kind: its name and what it says of itself, or that it was not asked.
std::string what_is_read(const opal::PluginRegistry& registry, opal::PluginKind kind) {
  std::string lines;
  for (const opal::RegisteredType& type : registry.types()) {
    if (type.kind != kind) continue;
    lines += "\n  " + type.info.name + ": " + type.description;
    if (!registry.is_listed(type.info.name)) lines += " (not asked: trusted_plugins does not name " + type.plugin + ")";
  }
  return lines;
}

}  // namespace

bool is_map_document(const std::string& source) {
  const std::string extension = fs::path(source).extension().string();
  return extension == ".jsonld" || extension == ".json";
}

opal::PluginRegistry load_plugins() {
  opal::PluginRegistry registry;
  for (const std::string& folder : opal::plugin_folders())
    for (const std::string& refusal : registry.announce_all(folder)) tell_refusal(refusal);
  return registry;
}

opal::PluginRegistry load_plugins(const opal::Deployment& deployment) {
  return opal::trusted_by(deployment, load_plugins());
}

opal::PluginRegistry load_plugins(const std::vector<std::string>& further_folders) {
  opal::PluginRegistry registry = load_plugins();
  std::set<fs::path> loaded;
  for (const std::string& folder : opal::plugin_folders()) loaded.insert(fs::weakly_canonical(folder));
  for (const std::string& folder : further_folders) {
    if (!loaded.insert(fs::weakly_canonical(folder)).second) continue;  // OPAL_PLUGIN_PATH may name it, too
    for (const std::string& refusal : registry.announce_all(folder)) throw opal::ConfigError(refusal);
  }
  return registry;
}

const opal::RegisteredType& importer_of(const opal::PluginRegistry& registry, const std::string& source) {
  if (!fs::exists(source)) throw opal::MapError(source + ": does not exist");
  const opal::ForeignFile foreign = opal::what_foreign_file(source);
  if (foreign.is_placeholder) throw opal::MapError(source + foreign.what);
  const std::string name = recognizing<opal::MapImporter>(registry, opal::PluginKind::map_importer, source);
  if (name.empty() && !foreign.what.empty()) throw opal::MapError(source + foreign.what);
  if (name.empty() && fs::is_directory(source))
    throw opal::MapError(source + ": is a folder, expected a map document or a source to import");
  if (name.empty())
    throw opal::MapError(source +
                         ": no importer recognizes this file; maps are read from\n  documents of Opal (.jsonld)" +
                         what_is_read(registry, opal::PluginKind::map_importer));
  return registry.type(name);
}

opal::MapImport import_map(const opal::PluginRegistry& registry, const std::string& source,
                           const nlohmann::json& options) {
  return registry.make<opal::MapImporter>(importer_of(registry, source).info.name, options)->import(source);
}

std::string name_of_map(const std::string& path) {
  const std::filesystem::path stem = std::filesystem::path(path).stem();
  return (stem.extension() == ".map" ? stem.stem() : stem).string();
}

std::shared_ptr<const opal::SemanticMap> load_map(const opal::PluginRegistry& registry, const std::string& source) {
  if (const auto stored = opal::read_store_source(source)) return load_stored_map(registry, *stored).map;
  return is_map_document(source) ? opal::SemanticMap::read(source) : import_map(registry, source).map;
}

VersionedMap load_versioned_map(const opal::PluginRegistry& plugins, const opal::Deployment& deployment) {
  const std::string& source = deployment.map;
  const opal::PluginRegistry registry = opal::trusted_by(deployment, plugins);
  if (const auto stored = opal::read_store_source(source)) {
    const VersionedMap loaded = load_stored_map(registry, *stored);
    return {with_overlays(loaded.map, deployment.overlays), loaded.version};
  }
  if (is_map_document(source)) return {with_overlays(load_map(registry, source), deployment.overlays), {}};
  const std::string& importer = importer_of(registry, source).info.name;
  const opal::MapImport imported = import_map(registry, source, opal::importer_options(deployment, registry, importer));
  return {with_overlays(imported.map, deployment.overlays), {}};
}

void expect_map(const opal::Deployment& deployment, const std::string& config) {
  if (deployment.map.empty()) throw opal::ConfigError(config + ": /map: missing; name a map here or with --map");
}

std::shared_ptr<const opal::SemanticMap> load_map(const opal::PluginRegistry& plugins,
                                                  const opal::Deployment& deployment) {
  return load_versioned_map(plugins, deployment).map;
}

nlohmann::json import_options(const opal::MapDamage& damage) {
  if (damage.thick_m > 0) return {{"thicken_m", damage.thick_m}};
  return nlohmann::json::object();
}

std::shared_ptr<const opal::SemanticMap> load_map(const opal::PluginRegistry& registry, const std::string& source,
                                                  const opal::MapDamage& damage) {
  const bool is_made = is_map_document(source) || opal::read_store_source(source);
  if (is_made && damage.thick_m > 0)
    throw opal::ConfigError(source + ": damage thick= is done to grids before they are imported, found a document");
  return opal::damaged_map(
      is_made ? *load_map(registry, source) : *import_map(registry, source, import_options(damage)).map, damage);
}

std::string log_source_of(const opal::PluginRegistry& registry, const std::string& path) {
  if (!fs::exists(path)) throw opal::LogError(path + ": does not exist");
  const auto kind = opal::PluginKind::log_source;
  const std::string source = recognizing<opal::LogSource>(registry, kind, path);
  const std::string other = fs::is_directory(path) ? recognizing<opal::LogSource>(registry, kind, path, source) : "";
  if (!source.empty() && !other.empty())
    throw opal::LogError(path + ": several recordings (for " + source + " and for " + other +
                         "), expected one of them");
  if (source.empty() && fs::is_regular_file(path) && fs::is_empty(path))
    throw opal::LogError(path + ": is empty, expected a recorded log");
  if (source.empty() && fs::is_directory(path))
    throw opal::LogError(path + ": is a folder, expected a log, or a folder with .db3, .mcap or .bag files");
  if (source.empty())
    throw opal::LogError(path + ": no log source recognizes this file; logs are read by" +
                         what_is_read(registry, kind));
  return source;
}

std::shared_ptr<const opal::LogSource> log_source(const opal::PluginRegistry& registry, const std::string& source,
                                                  const opal::Deployment& deployment,
                                                  const std::vector<std::string>& words) {
  nlohmann::json options = opal::log_source_options(deployment, registry, source);
  options.merge_patch(opal::parse_options(source, registry.type(source).options, words));
  return opal::trusted_by(deployment, registry).make<opal::LogSource>(source, options);
}

std::string log_sources_doubt(const opal::Deployment& deployment, const std::vector<std::string>& used) {
  std::vector<std::string> given;
  for (const opal::PartConfig& source : deployment.log_sources) {
    if (std::find(used.begin(), used.end(), source.type) != used.end()) return "";
    given.push_back(source.type);
  }
  if (given.empty()) return "";
  return deployment.file + ": /log_sources: has options for " + opal::listed(given) + ", and none for " +
         opal::listed(used) + ": they are not used";
}

std::unique_ptr<opal::LogReader> open_log(const opal::PluginRegistry& plugins, const std::string& path,
                                          const opal::Deployment& deployment, const std::vector<std::string>& words) {
  const opal::PluginRegistry registry = opal::trusted_by(deployment, plugins);
  const std::string source = log_source_of(registry, path);
  const bool has_options = !registry.type(source).options.empty();
  const std::string doubt = has_options ? log_sources_doubt(deployment, {source}) : "";
  if (!doubt.empty()) opal::warn("opal: " + doubt);
  return log_source(registry, source, deployment, words)->open_for(path, deployment.lasers);
}

}  // namespace opal::session
