#pragma once

#include <opal/common/export.hpp>

#include <filesystem>
#include <string>

namespace opal {

/// Where this user keeps what can be made again: the folder that an environment variable names (empty: nowhere), or
/// opal/NAME in XDG_CACHE_HOME, or in ~/.cache. Empty if there is no home either.
OPAL_EXPORT std::filesystem::path cache_folder(const char* variable, const std::string& name);

/// The same for what cannot be made again: opal/NAME in XDG_STATE_HOME, or in ~/.local/state.
OPAL_EXPORT std::filesystem::path state_folder(const char* variable, const std::string& name);

}  // namespace opal
