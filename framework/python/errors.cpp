#include "python/bindings.hpp"

#include "common/write_error.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

namespace opal::python {

namespace py = pybind11;

/// The exceptions of C++ under the same names, with the same words.
template <class E>
void bind_error(py::module_& module, const char* name, py::handle base, const char* meaning) {
  py::object error = py::register_exception<E>(module, name, base);
  error.attr("__module__") = "opal";
  error.attr("__doc__") = meaning;
}

void bind_errors(py::module_& module) {
  bind_error<Error>(module, "Error", PyExc_Exception,
                    "Wrong input: the message names file, place, what was found and what was expected.");
  const py::object base = module.attr("Error");
  bind_error<ConfigError>(module, "ConfigError", base, "A deployment, sensor or query document is unusable.");
  bind_error<MapError>(module, "MapError", base, "A map, or a source that a map is imported from, is unusable.");
  bind_error<LogError>(module, "LogError", base, "A recorded log is unusable as a whole.");
  bind_error<EventError>(module, "EventError", base, "An event stream is unusable from some event on.");
  bind_error<PluginError>(module, "PluginError", base, "A plugin was refused, or failed when called.");
  bind_error<JsonError>(module, "JsonError", base, "A text is no acceptable JSON.");
  bind_error<WriteError>(module, "WriteError", base, "A file or folder cannot be written.");
}

}  // namespace opal::python
