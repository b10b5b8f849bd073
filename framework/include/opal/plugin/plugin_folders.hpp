#pragma once

#include <opal/common/export.hpp>

#include <string>
#include <vector>

namespace opal {

/// Where the running program's own plugins are: the folder of the installation (lib/opal/plugins) or the
/// build (plugins) that libopal.so itself belongs to.
OPAL_EXPORT std::string own_plugin_folder();

/// The own folder, then the folders in the environment variable OPAL_PLUGIN_PATH (separated by colons), each
/// once.
OPAL_EXPORT std::vector<std::string> plugin_folders();

}  // namespace opal
