#pragma once

#include <opal/deployment/deployment.hpp>
#include <opal/map/map_importer.hpp>
#include <opal/plugin/plugin_registry.hpp>
#include <opal/sensing/log_source.hpp>
#include "map_tools/test_maps/map_damage.hpp"
#include "session/stored_maps.hpp"

#include <memory>
#include <string>
#include <vector>

namespace opal::session {

/// What several verbs begin with.

/// All plugins of the program's folders; refused ones are reported on stderr and left out.
opal::PluginRegistry load_plugins();

/// Of these, the ones that a deployment trusts: no other code runs for what is made of them.
opal::PluginRegistry load_plugins(const opal::Deployment& deployment);

/// The same with those of further folders, of which none may be refused. @throws opal::ConfigError if one is.
opal::PluginRegistry load_plugins(const std::vector<std::string>& further_folders);

/// Whether a map is read as a document of Opal, and not imported.
bool is_map_document(const std::string& source);

/// The importer that recognizes a source, as its plugin describes it. @throws opal::MapError if none does.
const opal::RegisteredType& importer_of(const opal::PluginRegistry& registry, const std::string& source);

/// Imports a map with the importer that recognizes the source. @throws opal::MapError if none does.
/// @param options  of that importer. @throws opal::PluginError if it does not accept them.
opal::MapImport import_map(const opal::PluginRegistry& registry, const std::string& source,
                           const nlohmann::json& options = nlohmann::json::object());

/// How a map is called by its file: "hall" of "sites/hall.map.yaml" and of "hall.jsonld".
std::string name_of_map(const std::string& path);

/// A map from a document, from the map store (store:BUILDING), or from any source that an importer recognizes.
std::shared_ptr<const opal::SemanticMap> load_map(const opal::PluginRegistry& registry, const std::string& source);

/// @throws opal::ConfigError if the deployment has no map. @param config  how the deployment was named.
void expect_map(const opal::Deployment& deployment, const std::string& config);

/// The map of a deployment with its overlays; a source is imported with the options that the deployment gives to
/// importers.
std::shared_ptr<const opal::SemanticMap> load_map(const opal::PluginRegistry& registry,
                                                  const opal::Deployment& deployment);

/// The same, with the version that it is of the map store. Overlays are not part of a version.
VersionedMap load_versioned_map(const opal::PluginRegistry& registry, const opal::Deployment& deployment);

/// What `thick_m` of a damage asks of the grid importer.
nlohmann::json import_options(const opal::MapDamage& damage);

/// The same, made worse. @throws opal::ConfigError if a document shall get thick walls: that is done to grids.
std::shared_ptr<const opal::SemanticMap> load_map(const opal::PluginRegistry& registry, const std::string& source,
                                                  const opal::MapDamage& damage);

/// Name of the log source that recognizes a log. @throws opal::LogError if none does; it tells which do read what.
std::string log_source_of(const opal::PluginRegistry& registry, const std::string& path);

/// A log source with options of a deployment and, before those, further ones (NAME=VALUE).
std::shared_ptr<const opal::LogSource> log_source(const opal::PluginRegistry& registry, const std::string& source,
                                                  const opal::Deployment& deployment,
                                                  const std::vector<std::string>& words);

/// In words, that a deployment gives options to log sources, and to none of these; empty: it does not.
std::string log_sources_doubt(const opal::Deployment& deployment, const std::vector<std::string>& used);

/// Opens a recorded log with the source that recognizes it. @throws opal::LogError if none does; it tells which do read
/// what.
/// @param deployment  has options for log sources.
/// @param words  NAME=VALUE, further options of that source; they win.
std::unique_ptr<opal::LogReader> open_log(const opal::PluginRegistry& registry, const std::string& path,
                                          const opal::Deployment& deployment = {},
                                          const std::vector<std::string>& words = {});

}  // namespace opal::session
