#pragma once

#include <pybind11/pybind11.h>

namespace opal::python_classes {

/// The interpreter of this process: the one that runs already, or one that is started now. It is never ended: classes
/// may live until the process ends.
/// @throws PluginError if it cannot be started.
void start_python();

/// The module of the package `opal` that finds and describes classes. With the lock of Python.
pybind11::module_ host_module();

}  // namespace opal::python_classes
