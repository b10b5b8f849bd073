#include "pattern.hpp"

#include "interpreter.hpp"

#include <pybind11/stl.h>

namespace py = pybind11;

PythonPattern::PythonPattern(const nlohmann::json& options) : object_(options, "match") {
  in_python([&] {
    const py::tuple shape = host_module().attr("checked_shape")(object_.get());
    for (const int slot : shape[0].cast<std::vector<int>>())
      shape_.slots.push_back(static_cast<opal::GeometryKind>(slot));
    shape_.reach_m = shape[1].cast<double>();
    shape_.neighbour_reach_m = shape[2].cast<double>();
  });
}

std::optional<opal::PatternInstance> PythonPattern::match(std::span<const opal::Feature* const> features) const {
  return in_python([&]() -> std::optional<opal::PatternInstance> {
    py::list members;
    for (const opal::Feature* feature : features) members.append(py::cast(*feature));
    const py::object found = object_.attribute("match")(members);
    if (found.is_none()) return std::nullopt;
    return host_module().attr("checked_pattern")(object_.get(), found).cast<opal::PatternInstance>();
  });
}
