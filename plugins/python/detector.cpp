#include "detector.hpp"

#include "interpreter.hpp"

#include <pybind11/stl.h>

namespace opal::python_classes {

namespace py = pybind11;

std::vector<Feature> PythonDetector::detect(const Scan& scan) const {
  return in_python([&] {
    const py::object found = object_.attribute("detect")(py::cast(scan));  // a copy: the class may keep it
    return host_module().attr("checked_features")(object_.get(), found).cast<std::vector<Feature>>();
  });
}

}  // namespace opal::python_classes
