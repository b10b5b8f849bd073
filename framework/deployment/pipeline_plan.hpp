#pragma once

#include <opal/map/semantic_map.hpp>
#include <opal/plugin/plugin_registry.hpp>

#include <string>
#include <vector>

namespace opal {

/// Which detectors and pattern templates a map calls for.
struct PipelinePlan {
  std::vector<std::string> detectors;   ///< type names, sorted
  std::vector<std::string> patterns;    ///< type names, sorted
  std::vector<std::string> on_request;  ///< pattern templates that run if a deployment names them, sorted
  std::vector<std::string> reasons;  ///< one line per registered detector and template: runs or not, and why; none for
                                     ///< what only runs classes that a deployment names
};

/// The map decides. A detector runs if it produces a feature type that the map holds for this sensor. A pattern
/// template runs if every type it consumes is on the map and produced by a detector that runs; if patterns of the
/// map name templates for this sensor, only the templates that they name run. Templates that say so themselves
/// (RegisteredType::on_request) run only where the map's patterns or a deployment name them.
OPAL_EXPORT PipelinePlan plan_pipeline(const SemanticMap& map, const std::string& sensor,
                                       const std::vector<RegisteredType>& types);

}  // namespace opal
