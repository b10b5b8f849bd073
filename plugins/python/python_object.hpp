#pragma once

#include <opal/plugin/registrar.hpp>

#include <pybind11/pybind11.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>

namespace opal::python_classes {

/// An object of Python that may be held and given up without the lock.
std::shared_ptr<pybind11::object> held(pybind11::object object);

/// An object of a class of Python. It may be held and given up without the lock; all else needs it.
class PythonObject {
 public:
  /// @param options  of the host's type: "class" and "options".
  /// @param method  that the class must have. @throws PluginError: file, line and what Python said.
  PythonObject(const nlohmann::json& options, const char* method);

  const pybind11::object& get() const { return *object_; }
  pybind11::object attribute(const char* name) const { return object_->attr(name); }
  /// Name, `consumes` and `produces` of the class.
  const TypeInfo& type_info() const { return info_; }

 private:
  std::shared_ptr<pybind11::object> object_;
  TypeInfo info_;
};

/// Calls Python with its lock. What it raises becomes an PluginError with file and line of the last frame.
template <class Call>
auto in_python(Call&& call);

/// "acme.py:17: ValueError: operands could not be broadcast". With the lock of Python.
std::string words_of(const pybind11::error_already_set& error);
[[noreturn]] void refuse(const std::string& words);

template <class Call>
auto in_python(Call&& call) {
  const pybind11::gil_scoped_acquire lock;
  try {
    return call();
  } catch (const pybind11::error_already_set& error) {
    refuse(words_of(error));
  } catch (const pybind11::cast_error& error) {
    refuse(error.what());
  }
}

}  // namespace opal::python_classes
