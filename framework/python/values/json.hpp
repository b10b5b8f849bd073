#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>

namespace opal::python {

/// Objects become dicts in the order of their members, arrays lists, null None.
template <class Json>
pybind11::object to_python(const Json& json) {
  namespace py = pybind11;
  if (json.is_object()) {
    py::dict members;
    for (const auto& [name, value] : json.items()) members[py::str(name)] = to_python(value);
    return members;
  }
  if (json.is_array()) {
    py::list elements;
    for (const Json& value : json) elements.append(to_python(value));
    return elements;
  }
  if (json.is_boolean()) return py::bool_(json.template get<bool>());
  if (json.is_number_integer()) return py::int_(json.template get<long long>());
  if (json.is_number()) return py::float_(json.template get<double>());
  if (json.is_string()) return py::str(json.template get_ref<const std::string&>());
  return py::none();
}

/// As Python's own module `json` writes it. @throws pybind11::error_already_set for what JSON does not
/// know (TypeError), and for numbers that are not finite (ValueError).
inline nlohmann::json from_python(const pybind11::object& object) {
  using namespace pybind11::literals;
  const pybind11::object text = pybind11::module_::import("json").attr("dumps")(object, "allow_nan"_a = false);
  return nlohmann::json::parse(text.cast<std::string>());
}

}  // namespace opal::python
