#pragma once

#include <opal/deployment/deployment.hpp>

#include <string>
#include <vector>

namespace opal {

/// The types of plugins of which something is made for a deployment on a map, each once: of its parts, of what the map
/// calls for, and of the importers and log sources that it lists. For classes, the types that run them.
/// @throws as `build_parts`.
OPAL_EXPORT std::vector<std::string> types_made(const Deployment& deployment, const PluginRegistry& registry,
                                                const SemanticMap& map);

}  // namespace opal
