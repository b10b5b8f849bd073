#pragma once

#include <opal/plugin/plugin.hpp>

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace opal {

/// Refuses what is no plugin for this API, without running any code of the file.
/// @throws PluginError naming the file.
void require_plugin_file(const std::string& file);

/// Opens a file that has passed `require_plugin_file`; its static constructors run.
/// @return the descriptor, which holds the library: whatever comes from the plugin's code (objects,
/// factories,
///         exceptions) must be gone before the last copy of it, unless the library is kept.
/// @throws PluginError naming the file.
std::shared_ptr<const PluginDescriptor> open_plugin(const std::string& file);

/// From now on an open library stays in the process, even if nobody holds it.
void keep_until_exit(const std::string& file);

/// Makes one call into a plugin.
/// @return the text of what it threw, copied so that the exception itself is gone; nullopt if it returned.
template <class Call>
std::optional<std::string> failure_of(Call&& call) {
  try {
    std::forward<Call>(call)();
    return std::nullopt;
  } catch (const std::exception& error) {
    return std::string(error.what());
  } catch (...) {
    return std::string("threw something that is no std::exception");
  }
}

}  // namespace opal
