#include "python/map.hpp"

#include "map/check/map_check.hpp"
#include "map/map_file.hpp"
#include "python/bindings.hpp"
#include "python/plugins.hpp"
#include "python/values/arrays.hpp"
#include "python/values/json.hpp"
#include "python/values/map_arrays.hpp"
#include "python/values/map_graph.hpp"
#include "session/overlays.hpp"
#include "session/session.hpp"

#include <opal/map/object_words.hpp>

#include <pybind11/stl.h>

namespace opal::python {

namespace py = pybind11;

namespace {

using Text = std::optional<std::string>;

MapHandle read_map(const std::string& source, const std::vector<std::string>& overlays, const py::object& options) {
  const nlohmann::json given = options.is_none() ? nlohmann::json::object() : from_python(options);
  const py::gil_scoped_release others_run;
  const auto map =
      given.empty() ? session::load_map(*registry(), source) : session::import_map(*registry(), source, given).map;
  return {session::with_overlays(map, overlays)};
}

void write_map(const MapHandle& self, const std::string& path) { opal::write_map(*self.map, path); }

IntArray positions_of(const std::vector<MapFeatureNumber>& features) {
  std::vector<int> numbers;
  for (const MapFeatureNumber feature : features) numbers.push_back(feature.number());
  return array_of(std::span<const int>(numbers));
}

void bind_object(py::module_& module) {
  py::class_<MapObject>(module, "MapObject", "A thing in the building that the map names: a wall, a column, a door.")
      .def_readonly("id", &MapObject::id)
      .def_readonly("type", &MapObject::type, "\"opal:Wall\"; open: plugins invent types.")
      .def_property_readonly(
          "name", [](const MapObject& self) { return self.notes.name; }, "For people; may be empty.")
      .def_property_readonly(
          "features", [](const MapObject& self) { return positions_of(self.features); },
          "Positions in Map.features; shape (N,).")
      .def("__repr__", [](const MapObject& self) {
        return "<opal.MapObject " + object_words(self.type, self.id, self.notes.name, false) + ">";
      });
}

void bind_feature(py::module_& module) {
  py::class_<MapFeature>(module, "MapFeature", "One shape through which a sensor perceives an object; map frame.")
      .def_readonly("id", &MapFeature::id)
      .def_property_readonly(
          "object", [](const MapFeature& self) { return self.object.number(); }, "Position in Map.objects.")
      .def_readonly("type", &MapFeature::type, "What a detector must produce to see it.")
      .def_readonly("sensor", &MapFeature::sensor, "That perceives it; empty: none does.")
      .def_property_readonly(
          "shape", [](const MapFeature& self) { return kind_name(self.geometry); },
          "\"point\", \"oriented_point\", \"segment\" or \"circle\".")
      .def_property_readonly(
          "numbers",
          [](const MapFeature& self) { return array_of(std::span<const double>(numbers_of(self.geometry))); },
          "point: x, y; oriented_point: x, y, heading, opening; segment: x, y of begin, x, y of end; "
          "circle: x, y, radius [m, rad].")
      .def_readonly("position_sigma_m", &MapFeature::position_sigma_m)
      .def_readonly("existence", &MapFeature::existence, "Probability that it is there.")
      .def("__repr__", [](const MapFeature& self) {
        return "<opal.MapFeature " + self.id + ", " + self.type + ", " + kind_name(self.geometry) + ">";
      });
}

void bind_pattern(py::module_& module) {
  py::class_<MapPattern>(module, "MapPattern", "A relation between features that the map itself names.")
      .def_readonly("id", &MapPattern::id)
      .def_readonly("template", &MapPattern::pattern_template, "Name of the pattern template.")
      .def_property_readonly(
          "features", [](const MapPattern& self) { return positions_of(self.features); },
          "Positions in Map.features, in the order of the template; shape (N,).")
      .def_readonly("subpatterns", &MapPattern::subpatterns)
      .def_property_readonly("dimensions",
                             [](const MapPattern& self) { return array_of(std::span<const double>(self.dimensions)); })
      .def("__repr__",
           [](const MapPattern& self) { return "<opal.MapPattern " + self.id + ", " + self.pattern_template + ">"; });
}

/// The features of one shape as an array.
template <GeometryKind kind>
Array shapes(const MapHandle& self, const Text& type, const Text& sensor) {
  return shape_table(*self.map, kind, type, sensor);
}

void bind_shapes(py::class_<MapHandle>& map) {
  const auto type = py::arg("type") = py::none();
  const auto sensor = py::arg("sensor") = py::none();
  map.def("segments", &shapes<GeometryKind::segment>, type, sensor,
          "Features that are faces: x, y of begin, x, y of end [m]; shape (N, 4). The visible side is to the left.")
      .def("circles", &shapes<GeometryKind::circle>, type, sensor, "x, y, radius [m]; shape (N, 3).")
      .def("points", &shapes<GeometryKind::point>, type, sensor, "x, y [m]; shape (N, 2).")
      .def("corners", &shapes<GeometryKind::oriented_point>, type, sensor,
           "Oriented points: x, y [m], heading, opening [rad]; shape (N, 4).");
}

}  // namespace

void bind_map(py::module_& module) {
  bind_object(module);
  bind_feature(module);
  bind_pattern(module);
  py::class_<MapHandle> map(module, "Map", "The static building. Frame: map; units: metres, radians.");
  map.def_property_readonly("name", [](const MapHandle& self) { return self.map->name(); })
      .def_property_readonly(
          "objects", [](const MapHandle& self) { return self.map->objects(); }, "By id.")
      .def_property_readonly(
          "features", [](const MapHandle& self) { return self.map->features(); }, "By id and sensor.")
      .def_property_readonly(
          "patterns", [](const MapHandle& self) { return self.map->patterns(); },
          "By id; empty without a pattern layer.")
      .def(
          "graph", [](const MapHandle& self) { return map_graph(*self.map); },
          "(nodes, edges). A node is a dict with \"kind\" (object, feature, point, pattern), \"id\" and what belongs "
          "to "
          "it. An edge is (from, to, kind): positions in nodes, and perceived_by, made_of, member or subpattern.")
      .def(
          "check", [](const MapHandle& self) { return check_map(*self.map).sentences(); },
          "What `opal map check` says of the map's contents, as sentences; doubts last.")
      .def(
          "json_ld", [](const MapHandle& self) { return to_python(self.map->to_json_ld()); },
          "The map as a JSON-LD document.")
      .def("write", &write_map, py::arg("path"), "Writes the JSON-LD document. Raises opal.WriteError.")
      .def("__repr__", [](const MapHandle& self) {
        return "<opal.Map " + self.map->name() + ": " + std::to_string(self.map->objects().size()) + " objects, " +
               std::to_string(self.map->features().size()) + " features>";
      });
  bind_shapes(map);
  module.def("read_map", &read_map, py::arg("source"), py::arg("overlays") = std::vector<std::string>(),
             py::arg("options") = py::none(),
             "A map of a document, of store:BUILDING, or of any source that an importer recognizes.\n\n"
             "overlays: paths of documents that correct the map; what does not fit is told on stderr.\n"
             "options: a dict, of the importer.\nRaises opal.MapError, naming file, place, found and expected.");
}

}  // namespace opal::python
