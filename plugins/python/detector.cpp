#include "detector.hpp"

#include "interpreter.hpp"

#include <pybind11/stl.h>

namespace py = pybind11;

std::vector<opal::Feature> PythonDetector::detect(const opal::Scan& scan) const {
  return in_python([&] {
    const py::object found = object_.attribute("detect")(py::cast(scan));  // a copy: the class may keep it
    return host_module().attr("checked_features")(object_.get(), found).cast<std::vector<opal::Feature>>();
  });
}
