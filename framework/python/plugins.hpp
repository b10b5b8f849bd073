#pragma once

#include <opal/plugin/plugin_registry.hpp>

#include <memory>

namespace opal::python {

/// The plugins of this process: those that the program `opal` finds, and those of folders that were added. Made when it
/// is first asked for.
std::shared_ptr<const PluginRegistry> registry();

}  // namespace opal::python
