#pragma once

#include <string>

namespace opal::cli {

/// What the list is to hold.
struct TrustedListRequest {
  std::string config;  ///< a deployment: a file, or the name of one that ships; empty: no list is asked for
  std::string map;     ///< instead of the deployment's; it decides which detectors and patterns run
  std::string log;     ///< whose log source is to be in the list; empty: none beside those that the deployment lists
};

/// "trusted_plugins" of a deployment as the files are now: what is made for it on its map, ready to paste. The list
/// that the deployment has is not asked. @throws Error if the deployment does not run with this map.
std::string trusted_list(const TrustedListRequest& request);

}  // namespace opal::cli
