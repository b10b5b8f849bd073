#pragma once

#include <string>

namespace opal::session {

/// What ships with the program: it lies beside the sources, or below share/opal of an installed Opal.

/// @param name  below the root of the sources: "configs/default.jsonld", "maps/malaga".
/// @throws opal::ConfigError if it is nowhere.
std::string shipped_file(const std::string& name);

/// A configuration that ships with the program. @param name  "default.jsonld". @throws opal::ConfigError likewise.
std::string shipped_config(const std::string& name);

/// A configuration by its path; or, if there is no such file, by the name of one that ships: "malaga", "malaga.jsonld".
/// @throws opal::ConfigError if it is neither, naming those that ship.
std::string config_file(const std::string& name);

}  // namespace opal::session
