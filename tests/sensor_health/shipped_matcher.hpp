#pragma once

#include <opal/plugin/plugin_registry.hpp>

#include <memory>

/// The scan matcher that Opal ships, loaded once per program.
inline std::shared_ptr<const opal::ScanMatcher> shipped_matcher() {
  static const opal::PluginRegistry registry = [] {
    opal::PluginRegistry loaded;
    loaded.load(OPAL_PLUGIN_DIR "/point_to_line_matcher.so");
    return loaded;
  }();
  return registry.make<opal::ScanMatcher>("opal:PointToLineMatcher");
}
