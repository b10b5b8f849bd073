#pragma once

#include <opal/plugin/plugin_registry.hpp>

namespace opal {

/// Where the running program's own plugins are: the folder `plugins` of the build or installation that libopal.so
/// itself belongs to.
OPAL_EXPORT std::string own_plugin_folder();

}  // namespace opal
