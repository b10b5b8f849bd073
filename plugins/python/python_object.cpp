#include "python_object.hpp"

#include "interpreter.hpp"

#include <opal/common/error.hpp>

#include <pybind11/stl.h>

namespace opal::python_classes {

namespace py = pybind11;

namespace {

/// Gives up an object of Python from any thread, at any time; after the end of the interpreter there is nothing to do.
struct GiveUp {
  void operator()(py::object* object) const {
    if (Py_IsInitialized() == 0) {
      object->release();
      delete object;
      return;
    }
    const py::gil_scoped_acquire lock;
    delete object;
  }
};

}  // namespace

std::shared_ptr<py::object> held(py::object object) { return {new py::object(std::move(object)), GiveUp()}; }

std::string words_of(const py::error_already_set& error) {
  try {
    return host_module().attr("told")(error.value(), error.trace() ? error.trace() : py::none()).cast<std::string>();
  } catch (const py::error_already_set& second) {
    return second.what();
  }
}

void refuse(const std::string& words) { throw PluginError(words); }

PythonObject::PythonObject(const nlohmann::json& options, const char* method) {
  start_python();
  in_python([&] {
    const auto source = options.at("class").get<std::string>(), arguments = options.at("options").get<std::string>();
    const py::object made = host_module().attr("make")(source, arguments, method);
    object_ = held(made);
    const auto names = [&](const char* attribute) {
      return py::getattr(made, attribute, py::tuple()).cast<std::vector<std::string>>();
    };
    info_ = {source, names("consumes"), names("produces")};
  });
}

}  // namespace opal::python_classes
