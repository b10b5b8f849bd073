#pragma once

#include "map_tools/map_join.hpp"

#include <CLI/CLI.hpp>

namespace opal::cli {

/// The options of every verb that puts maps side by side.
struct JoinOptions {
  MapJoin join;

  void add_to(CLI::App& verb) {
    verb.add_option("--gap", join.gap_m, "between neighbouring maps [m]")->capture_default_str();
    verb.add_option("--copies", join.copies,
                    "also add so many look-alikes of all maps together: mirrored, and stretched by 5 to 30 %")
        ->capture_default_str();
  }
};

}  // namespace opal::cli
