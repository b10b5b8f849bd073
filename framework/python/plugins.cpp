#include "python/plugins.hpp"

#include "python/bindings.hpp"
#include "session/session.hpp"

#include <opal/plugin/testing/plugin_contract.hpp>

#include <pybind11/stl.h>

#include <mutex>

namespace opal::python {

namespace py = pybind11;

namespace {

/// A registry that is in use never changes: a folder that is added makes another one.
class SharedRegistry {
 public:
  std::shared_ptr<const PluginRegistry> get() {
    const std::lock_guard lock(mutex_);
    if (!registry_) registry_ = std::make_shared<const PluginRegistry>(session::load_plugins(folders_));
    return registry_;
  }
  void add(const std::string& folder) {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> folders = folders_;
    folders.push_back(folder);
    registry_ = std::make_shared<const PluginRegistry>(session::load_plugins(folders));
    folders_ = std::move(folders);
  }

 private:
  std::mutex mutex_;
  std::vector<std::string> folders_;
  std::shared_ptr<const PluginRegistry> registry_;
};

SharedRegistry& shared_registry() {
  static SharedRegistry registry;
  return registry;
}

}  // namespace

std::shared_ptr<const PluginRegistry> registry() { return shared_registry().get(); }

void bind_plugins(py::module_& module) {
  py::class_<RegisteredType>(module, "PluginType", "One type that a plugin offers.")
      .def_property_readonly("name", [](const RegisteredType& type) { return type.info.name; })
      .def_property_readonly(
          "kind", [](const RegisteredType& type) { return name_of(type.kind); },
          "\"FeatureDetector\", \"HypothesisScorer\": the interface that it implements.")
      .def_readonly("plugin", &RegisteredType::plugin)
      .def_readonly("file", &RegisteredType::file, "Path of the shared library.")
      .def_readonly("description", &RegisteredType::description)
      .def_property_readonly("consumes", [](const RegisteredType& type) { return type.info.consumes; })
      .def_property_readonly("produces", [](const RegisteredType& type) { return type.info.produces; })
      .def("__repr__", [](const RegisteredType& type) {
        return "<opal.PluginType " + type.info.name + ", " + name_of(type.kind) + ">";
      });
  module.def(
      "plugins", [] { return registry()->types(); },
      "All types that plugins offer, by name. No code of a plugin runs for this.");
  module.def(
      "check_class", &testing::class_violations, py::arg("source"), py::call_guard<py::gil_scoped_release>(),
      "Puts a class that takes the place of a plugin (\"my.py:Likelihood\") through the contract of its kind, with "
      "its default options. Returns what it breaks, a sentence each; empty: nothing.");
  module.def(
      "add_plugins", [](const std::string& folder) { shared_registry().add(folder); }, py::arg("folder"),
      "Adds the plugins of a folder for this process, as OPAL_PLUGIN_PATH does. Raises opal.Error if one is "
      "refused.");
}

}  // namespace opal::python
