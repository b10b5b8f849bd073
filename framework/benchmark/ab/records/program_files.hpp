#pragma once

#include <opal/plugin/plugin_registry.hpp>

#include <nlohmann/json.hpp>

namespace opal::ab {

/// Version and digests of the program that runs, and of libopal.so as it uses it. @throws Error naming a file that
/// cannot be read.
nlohmann::ordered_json program_files();

/// Every plugin once, by name, with version and the digests of its library and of its description, which has the
/// defaults of options. @throws Error naming a file that cannot be read.
nlohmann::ordered_json plugin_files(const PluginRegistry& registry);

}  // namespace opal::ab
