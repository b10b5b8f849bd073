#pragma once

#include <opal/common/error.hpp>

#include <string>

namespace opal {

/// @throws PluginError that names the file of the plugin.
[[noreturn]] inline void refuse_file(const std::string& file, const std::string& cause) {
  throw PluginError(file + ": " + cause);
}

/// @throws PluginError that names the type and its option.
[[noreturn]] inline void refuse_option(const std::string& type_name, const std::string& option,
                                       const std::string& complaint) {
  throw PluginError(type_name + ": option " + option + ": " + complaint);
}

}  // namespace opal
