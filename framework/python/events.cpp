#include "python/bindings.hpp"
#include "python/values/json.hpp"
#include "viewer/reading/event_text.hpp"
#include "viewer/reading/line_reader.hpp"
#include "viewer/reading/run_reader.hpp"

#include <opal/common/error.hpp>

namespace opal::python {

namespace py = pybind11;

namespace {

/// The events of a run, one dict after the other. A last line that was cut off ends the stream.
class EventReader {
 public:
  explicit EventReader(const std::string& out) : file_(event_file(out)), lines_(file_) {}

  py::object next() {
    while (lines_.next()) {
      if (lines_.line().find_first_not_of(" \t\r") == std::string_view::npos) continue;
      try {
        return to_python(parse_event(lines_.line()));
      } catch (const EventError& error) {
        if (!lines_.is_whole()) break;
        throw EventError(file_ + ":" + std::to_string(lines_.number()) + ": " + error.what());
      }
    }
    throw py::stop_iteration();
  }

 private:
  std::string file_;
  LineReader lines_;
};

}  // namespace

void bind_events(py::module_& module) {
  py::class_<EventReader>(module, "EventReader", "The events of a run as dicts (docs/events.md).")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &EventReader::next);
  module.def(
      "read_events", [](const std::string& out) { return std::make_unique<EventReader>(out); }, py::arg("out"),
      "The events of a folder that `opal localize` wrote, or of a file. Raises opal.EventError.");
}

}  // namespace opal::python
