#pragma once

#include <opal/common/error.hpp>
#include <opal/plugin/plugin_registry.hpp>

#include <string>

/// The plugins of the build, loaded once per program. @throws PluginError if one of them is refused.
inline const opal::PluginRegistry& shipped_plugins() {
  static const opal::PluginRegistry loaded = [] {
    opal::PluginRegistry fresh;
    for (const std::string& refusal : fresh.load_all(OPAL_PLUGIN_DIR)) throw opal::PluginError(refusal);
    return fresh;
  }();
  return loaded;
}
