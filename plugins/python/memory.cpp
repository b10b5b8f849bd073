#include "memory.hpp"

#include "python_object.hpp"

namespace opal::python_classes {

namespace py = pybind11;

PythonMemory::PythonMemory(py::object state) : state_(held(std::move(state))) {}

std::unique_ptr<ScorerMemory> PythonMemory::copy() const {
  return in_python(
      [&] { return std::make_unique<PythonMemory>(py::module_::import("copy").attr("deepcopy")(*state_)); });
}

void PythonMemory::replace(py::object state) { *state_ = std::move(state); }

const py::object& state_of(const ScorerMemory& memory) { return static_cast<const PythonMemory&>(memory).state(); }

void change(ScorerMemory& memory, py::object returned) {
  if (!returned.is_none()) static_cast<PythonMemory&>(memory).replace(std::move(returned));
}

}  // namespace opal::python_classes
