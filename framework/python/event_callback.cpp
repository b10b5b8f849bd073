#include "python/event_callback.hpp"

#include "python/values/json.hpp"

namespace opal::python {

namespace py = pybind11;

void EventCallback::write(const nlohmann::ordered_json& event) {
  if (failure_) return;
  const py::gil_scoped_acquire python;
  try {
    function_(to_python(event));
  } catch (py::error_already_set& failure) {
    failure_.emplace(failure);
  }
}

void EventCallback::rethrow() {
  if (!failure_) return;
  py::error_already_set failure = *failure_;
  failure_.reset();
  throw failure;
}

}  // namespace opal::python
