#pragma once

#include <opal/localization/localizer.hpp>
#include <opal/map/semantic_map.hpp>
#include <opal/plugin/plugin_registry.hpp>
#include <opal/sensing/scan.hpp>

#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// One replaceable part that a deployment asks for.
struct PartConfig {
  std::string type;                                   ///< "opal:LineDetector"
  nlohmann::json options = nlohmann::json::object();  ///< as written; the plugin's description checks them
  std::string where;                                  ///< file and JSON pointer, for messages
};

/// One scorer that a deployment asks for, and what its opinion is worth.
struct ScorerConfig {
  PartConfig part;                        ///< the scorer's type and options
  ScorerRole role = ScorerRole::decides;  ///< whether it decides
  double weight = 1;                      ///< of its scores in the decision
  std::string name = {};                  ///< by which its scores are known; empty: its type

  bool decides() const { return role == ScorerRole::decides; }  ///< its scores take part in the decision
};

/// How Opal runs in one building with one robot: a document of configs/. Every field has a default except the
/// scorers; docs/deploy_a_building.md explains the document.
struct Deployment {
  std::string file;  ///< path of the document, for messages
  std::string map;   ///< path of the map, resolved against the document's folder; empty: the caller says
  std::vector<std::string>
      overlays;  ///< paths of documents that change the map, resolved likewise; see map_overlay.hpp
  std::vector<LaserModel> lasers{1};  ///< the sensors; at least one
  bool describes_laser = false;       ///< the document says more of the sensors than their id
  bool describes_mount = false;       ///< the document says of every laser where it sits on the robot
  OdometryScale odometry;             ///< by which odometry is corrected
  KeyframeOptions keyframes;          ///< how densely scans are taken
  LocalMapOptions local_map;          ///< how features of several scans are put together
  std::optional<PartConfig> matcher;  ///< none: odometry as it is
  /// Absent: all that the map calls for (see plan_pipeline). Present: of these, the ones the map calls for.
  std::optional<std::vector<PartConfig>> detectors;
  /// The same for pattern templates.
  std::optional<std::vector<PartConfig>> patterns;
  std::vector<ScorerConfig> scorers;              ///< at least one; in the order of the document
  LocalizerOptions stages = {};                   ///< options of everything behind the local map
  std::vector<PartConfig> importers;              ///< options for those that make the map, if it is made of a source
  std::vector<PartConfig> log_sources;            ///< options for those that read a recorded log: topics, frames
  std::optional<TrustedPlugins> trusted_plugins;  ///< whose code may run, by digest; absent: that of all plugins
};

/// Reads a deployment strictly: unknown keys, wrong types and values out of range are errors, and lists keep
/// their order.
/// @throws ConfigError "configs/hall.jsonld: /sensor/beams: 0, expected an integer from 1 to 100000";
/// JsonError for text that is no JSON.
OPAL_EXPORT Deployment read_deployment(const std::string& path);
/// The same for a document in memory.
/// @param text  a whole JSON-LD document.
/// @param file  what messages call the document, and what a relative map path starts from.
OPAL_EXPORT Deployment parse_deployment(const std::string& text, const std::string& file);

/// The same with the lasers that recorded or simulated, under the name that the deployment gives its own.
OPAL_EXPORT Deployment with_lasers(Deployment deployment, std::vector<LaserModel> lasers);

/// Whether one of the lasers takes its geometry from the log, or from the robot.
OPAL_EXPORT bool takes_geometry_from_log(const Deployment& deployment);

/// The plugins that a deployment trusts: all of them, or those of its list (PluginRegistry::trusting). The functions
/// below do this by themselves; what is made without them, for example a map, is made of these plugins.
OPAL_EXPORT PluginRegistry trusted_by(const Deployment& deployment, const PluginRegistry& registry);

/// The options that a deployment gives to an importer; an empty object if it gives none.
/// @throws ConfigError as `build_parts` does, for any of its importers.
OPAL_EXPORT nlohmann::json importer_options(const Deployment& deployment, const PluginRegistry& registry,
                                            const std::string& importer);

/// The options that a deployment gives to a log source, likewise.
OPAL_EXPORT nlohmann::json log_source_options(const Deployment& deployment, const PluginRegistry& registry,
                                              const std::string& log_source);

/// What `build_parts` checks before it makes anything: types that no plugin offers, types of another kind, plugins that
/// the deployment does not trust, and options that the plugin does not accept. @throws ConfigError naming file and JSON
/// pointer.
OPAL_EXPORT void check_parts(const Deployment& deployment, const PluginRegistry& registry);

/// Makes the parts of a localizer. Detectors and pattern templates are those that the map calls for, narrowed
/// and parametrised by the deployment.
/// @throws ConfigError naming file and JSON pointer for types that no plugin offers, types of another kind,
/// and options that the plugin does not accept; also if the map leaves no detector or no pattern, and for a plugin or a
/// class that is to be made and that the deployment does not trust. No code of an announced plugin has run then.
OPAL_EXPORT LocalizerParts build_parts(const Deployment& deployment, const PluginRegistry& registry,
                                       std::shared_ptr<const SemanticMap> map);

}  // namespace opal
