#pragma once

#include <pybind11/pybind11.h>

/// What the module `opal._opal` is made of. Each function adds one part; later parts use the types of earlier ones.
namespace opal::python {

void bind_errors(pybind11::module_& module);
void bind_plugins(pybind11::module_& module);
void bind_map(pybind11::module_& module);
void bind_scan(pybind11::module_& module);
void bind_deployment(pybind11::module_& module);
void bind_log(pybind11::module_& module);
void bind_estimate(pybind11::module_& module);
void bind_run(pybind11::module_& module);
void bind_localizer(pybind11::module_& module);
void bind_bench(pybind11::module_& module);
void bind_plugin_types(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);
void bind_events(pybind11::module_& module);

}  // namespace opal::python
