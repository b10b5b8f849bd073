#pragma once

#include <opal/map_overlay.hpp>

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

/// The option of every verb that reads a map which overlays may change.
struct OverlayFiles {
  std::vector<std::string> files;

  void add_to(CLI::App& verb, const std::string& instead = "") {
    verb.add_option("--overlay", files, "overlay document, may be given several times: what the map lacks or has wrong" + instead);
  }
};

using MapPtr = std::shared_ptr<const opal::SemanticMap>;

/// The map with the overlays of these files; what does not fit is told on stderr. @throws opal::MapError.
MapPtr with_overlays(const MapPtr& map, const std::vector<std::string>& files);
