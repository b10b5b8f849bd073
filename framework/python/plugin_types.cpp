#include "python/bindings.hpp"
#include "python/values/arrays.hpp"
#include "python/values/map_queries.hpp"

#include <opal/common/feature.hpp>
#include <opal/map/view/map_view.hpp>
#include <opal/patterns/pattern.hpp>

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace opal::python {

namespace py = pybind11;

namespace {

[[noreturn]] void refuse(const std::string& words) { throw std::invalid_argument(words); }

Geometry geometry_of(const std::string& shape, const std::vector<double>& n) {
  const auto expect = [&](std::size_t size, const char* meaning) {
    if (n.size() != size)
      refuse("numbers: " + std::to_string(n.size()) + " of a " + shape + ", expected " + std::to_string(size) + ": " +
             meaning);
  };
  if (shape == "point") {
    expect(2, "x, y");
    return Point(n[0], n[1]);
  }
  if (shape == "oriented_point") {
    expect(4, "x, y, heading, opening");
    return OrientedPoint{{n[0], n[1]}, n[2], n[3]};
  }
  if (shape == "segment") {
    expect(4, "x, y of begin, x, y of end");
    return Segment{{n[0], n[1]}, {n[2], n[3]}};
  }
  if (shape != "circle") refuse("shape: \"" + shape + "\", expected point, oriented_point, segment or circle");
  expect(3, "x, y, radius");
  return Circle{{n[0], n[1]}, n[2]};
}

Feature make_feature(const std::string& type, const std::string& shape, const std::vector<double>& numbers,
                     const std::vector<double>& sigmas, std::array<bool, 2> true_ends) {
  Feature feature{type, geometry_of(shape, numbers)};
  const std::size_t expected = shape == "point" || shape == "segment" ? 2 : 3;
  if (sigmas.size() != expected)
    refuse("sigmas: " + std::to_string(sigmas.size()) + " of a " + shape + ", expected " + std::to_string(expected));
  const auto is_finite = [](double number) { return std::isfinite(number); };
  if (!std::ranges::all_of(numbers, is_finite)) refuse("numbers: not finite, expected metres and radians");
  if (shape == "circle" && !(numbers[2] > 0)) refuse("numbers: a radius of 0 or less, expected more");
  if (!std::ranges::all_of(sigmas, [](double sigma) { return sigma >= 0 && std::isfinite(sigma); }))
    refuse("sigmas: negative or not finite, expected standard deviations");
  for (std::size_t k = 0; k < sigmas.size(); ++k)
    feature.covariance(Eigen::Index(k), Eigen::Index(k)) = sigmas[k] * sigmas[k];
  feature.true_end = true_ends;
  if (const auto* segment = std::get_if<Segment>(&feature.geometry)) feature.support_m = segment->length_m();
  return feature;
}

void bind_detected_feature(py::module_& module) {
  py::class_<Feature>(module, "Feature", "A shape that a detector found; the frame is that of whoever holds it.")
      .def(
          py::init(&make_feature), py::arg("type"), py::arg("shape"), py::arg("numbers"), py::arg("sigmas"),
          py::arg("true_ends") = std::array<bool, 2>{false, false},
          "type: \"acme:Post\". shape and numbers: as of MapFeature.\n"
          "sigmas: standard deviations of point (x, y), oriented_point (x, y, heading), circle (x, y, radius), segment "
          "(offset, heading).\ntrue_ends: of a segment, whether begin and end are where the object ends.")
      .def_readonly("type", &Feature::type)
      .def_property_readonly("shape", [](const Feature& self) { return kind_name(self.geometry); })
      .def_property_readonly(
          "numbers", [](const Feature& self) { return array_of(std::span<const double>(numbers_of(self.geometry))); },
          "As of MapFeature; shape (2,), (3,) or (4,).")
      .def_property_readonly(
          "covariance", [](const Feature& self) { return array_of(self.covariance); },
          "In the order of sigmas; shape (3, 3).")
      .def_readonly("support_m", &Feature::support_m, "Of a segment: how much of it is covered by measurements.")
      .def("__repr__",
           [](const Feature& self) { return "<opal.Feature " + self.type + ", " + kind_name(self.geometry) + ">"; });
}

Invariant invariant_of(const py::tuple& words) {
  if (words.size() != 2 && words.size() != 3) refuse("invariants: expected tuples of value, tolerance and comparison");
  const std::string comparison = words.size() == 3 ? words[2].cast<std::string>() : "equal";
  Invariant invariant{words[0].cast<double>(), words[1].cast<double>(), Comparison::equal};
  if (comparison == "mapped_at_most")
    invariant.comparison = Comparison::mapped_at_most;
  else if (comparison == "mapped_at_least")
    invariant.comparison = Comparison::mapped_at_least;
  else if (comparison != "equal")
    refuse("invariants: \"" + comparison + "\", expected equal, mapped_at_most or mapped_at_least");
  return invariant;
}

PatternInstance make_pattern(const std::vector<py::tuple>& invariants, const GivenArray& frame,
                             const std::optional<std::vector<int>>& members, bool symmetric,
                             std::array<double, 2> extent_m, double overhang_m) {
  PatternInstance pattern;
  for (const py::tuple& words : invariants) pattern.invariants.push_back(invariant_of(words));
  pattern.frame = pose_of(frame, "frame");
  if (members) pattern.members = *members;
  pattern.symmetric = symmetric;
  pattern.extent_min_m = extent_m[0];
  pattern.extent_max_m = extent_m[1];
  pattern.overhang_m = overhang_m;
  return pattern;
}

void bind_pattern_instance(py::module_& module) {
  py::class_<PatternInstance>(module, "Pattern",
                              "Features in a relation, by numbers that a rigid motion leaves unchanged.")
      .def(py::init(&make_pattern), py::arg("invariants"), py::arg("frame"), py::arg("members") = py::none(),
           py::arg("symmetric") = false, py::arg("extent_m") = std::array<double, 2>{0, 0}, py::arg("overhang_m") = 0.0,
           "invariants: tuples (value, tolerance) or (value, tolerance, comparison): equal, mapped_at_most, "
           "mapped_at_least.\nframe: a pose that moves with the features; shape (3,).\n"
           "members: for each slot the position of its feature; None: in the order given.\n"
           "symmetric: half a turn of the frame gives the same pattern.")
      .def_readwrite("members", &PatternInstance::members)
      .def_property_readonly(
          "frame", [](const PatternInstance& self) { return array_of(self.frame); }, "Shape (3,).")
      .def_readonly("symmetric", &PatternInstance::symmetric);
}

void bind_map_view(py::module_& module) {
  py::class_<MapView, std::unique_ptr<MapView, py::nodelete>>(
      module, "MapView", "The map as one sensor sees it, for scorers; valid as long as the localizer that asks.")
      .def_property_readonly(
          "features", [](const MapView& self) { return self.map().features(); },
          "All features of the map, perceivable or not.")
      .def_property_readonly("objects", [](const MapView& self) { return self.map().objects(); })
      .def_property_readonly(
          "bounds",
          [](const MapView& self) {
            const std::array<Point, 2> corners = self.bounds();
            return array_of(std::span<const Point>(corners));
          },
          "Least and greatest corner [m]; shape (2, 2).")
      .def_property_readonly_static(
          "clearance_cap_m", [](const py::object&) { return MapView::clearance_cap_m(); },
          "The largest answer of clearance.")
      .def(
          "clearance", &clearances, py::arg("points"),
          "Distance from each point of the map to the nearest surface, capped [m]; points: shape (..., 2), the answer: "
          "shape (...).")
      .def("likelihood_field", &likelihoods, py::arg("points"),
           "exp(-d^2 / (2 * 0.2^2)) of that distance; points: shape (..., 2), the answer: shape (...).")
      .def("nearest_facing", &nearest_facing, py::arg("points"), py::arg("viewer"),
           "The nearest surface that faces a viewer, as a position in features, -1: none; points: shape (..., 2), "
           "viewer: "
           "shape (2,) or as points, the answer: shape (...).")
      .def("first_crossing", &first_crossings, py::arg("origin"), py::arg("targets"),
           py::arg("min_penetration_m") = 0.0,
           "The first surface between an origin and each target: (feature, range [m], from_behind), -1: the way is "
           "free. "
           "origin: shape (2,) or as targets; targets: shape (..., 2); each answer: shape (...).");
}

}  // namespace

void bind_plugin_types(py::module_& module) {
  bind_detected_feature(module);
  bind_pattern_instance(module);
  bind_map_view(module);
}

}  // namespace opal::python
