#include "python/bindings.hpp"
#include "python/map.hpp"
#include "python/plugins.hpp"
#include "python/values/json.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include <opal/deployment/deployment.hpp>

#include <pybind11/stl.h>

namespace opal::python {

namespace py = pybind11;

namespace {

Deployment with_map(Deployment deployment, const std::string& source, const std::vector<std::string>& overlays) {
  deployment.map = source;
  deployment.overlays = overlays;
  return deployment;
}

Deployment make_deployment(const py::object& document, const std::string& file) {
  return parse_deployment(from_python(document).dump(), file);
}

MapHandle map_of(const Deployment& deployment) {
  if (deployment.map.empty())
    throw ConfigError(deployment.file + ": /map: missing; name a map there or with with_map()");
  const py::gil_scoped_release others_run;
  return {session::load_map(*registry(), deployment)};
}

std::vector<std::string> scorers_of(const Deployment& deployment) {
  std::vector<std::string> names;
  for (const ScorerConfig& scorer : deployment.scorers)
    names.push_back(scorer.name.empty() ? scorer.part.type : scorer.name);
  return names;
}

}  // namespace

void bind_deployment(py::module_& module) {
  py::class_<Deployment>(module, "Deployment", "How Opal runs in one building with one robot. Read only.")
      .def_readonly("file", &Deployment::file)
      .def_readonly("map", &Deployment::map, "Path of the map; empty: none is named.")
      .def_readonly("overlays", &Deployment::overlays)
      .def_readonly("lasers", &Deployment::lasers, "At least one.")
      .def_property_readonly("scorers", &scorers_of, "Names, in the order of the document.")
      .def("with_map", &with_map, py::arg("source"), py::arg("overlays") = std::vector<std::string>(),
           "The same deployment with another map.")
      .def(
          "with_lasers",
          [](const Deployment& self, std::vector<LaserModel> lasers) { return with_lasers(self, std::move(lasers)); },
          py::arg("lasers"), "The same deployment with other lasers, under the sensor id of its own.")
      .def("read_map", &map_of, "The map that it names, with its overlays. Raises opal.Error.")
      .def("__repr__", [](const Deployment& self) { return "<opal.Deployment " + self.file + ">"; });
  module.def(
      "read_deployment", [](const std::string& name) { return read_deployment(session::config_file(name)); },
      py::arg("name"),
      "A deployment of a file, or one that ships by its name: \"default\", \"malaga\". Raises opal.ConfigError.");
  module.def("make_deployment", &make_deployment, py::arg("document"), py::arg("file") = "deployment",
             "A deployment of a dict, with the members of a document.\n\n"
             "file: what messages call it, and what relative paths in it start from.");
  module.def("shipped_file", &session::shipped_file, py::arg("name"),
             "Path of what ships with Opal: \"maps/malaga/malaga-demo.log.gz\". Raises opal.ConfigError.");
}

}  // namespace opal::python
