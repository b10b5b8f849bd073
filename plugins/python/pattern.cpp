#include "pattern.hpp"

#include "interpreter.hpp"

#include <pybind11/stl.h>

namespace opal::python_classes {

namespace py = pybind11;

PythonPattern::PythonPattern(const nlohmann::json& options) : object_(options, "match") {
  in_python([&] {
    const py::tuple shape = host_module().attr("checked_shape")(object_.get());
    for (const int slot : shape[0].cast<std::vector<int>>()) shape_.slots.push_back(static_cast<GeometryKind>(slot));
    shape_.reach_m = shape[1].cast<double>();
    shape_.neighbour_reach_m = shape[2].cast<double>();
  });
}

std::optional<PatternInstance> PythonPattern::match(std::span<const Feature* const> features) const {
  return in_python([&]() -> std::optional<PatternInstance> {
    py::list members;
    for (const Feature* feature : features) members.append(py::cast(*feature));
    const py::object found = object_.attribute("match")(members);
    if (found.is_none()) return std::nullopt;
    return host_module().attr("checked_pattern")(object_.get(), found).cast<PatternInstance>();
  });
}

}  // namespace opal::python_classes
