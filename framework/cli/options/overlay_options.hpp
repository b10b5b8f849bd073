#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace opal::cli {

/// The option of every verb that reads a map which overlays may change.
struct OverlayFiles {
  std::vector<std::string> files;

  void add_to(CLI::App& verb, const std::string& instead = "") {
    verb.add_option("--overlay", files,
                    "overlay document, may be given several times: what the map lacks or has wrong" + instead);
  }
};

}  // namespace opal::cli
