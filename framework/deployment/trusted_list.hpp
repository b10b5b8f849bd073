#pragma once

#include "common/json/config_object.hpp"

#include <opal/deployment/deployment.hpp>

#include <optional>
#include <string>

namespace opal {

/// "trusted_plugins" of a deployment. @param file  path of the deployment, beside which files of classes are.
/// @return nullopt if there is no such key. @throws ConfigError naming the place.
std::optional<TrustedPlugins> read_trusted_plugins(ConfigObject& document, const std::string& file);

}  // namespace opal
