#include "benchmark/runs/answer.hpp"
#include "python/bindings.hpp"
#include "python/localizer_handle.hpp"
#include "python/values/arrays.hpp"

#include <opal/localization/decision/pose_estimate.hpp>

#include <pybind11/stl.h>

namespace opal::python {

namespace py = pybind11;

namespace {

py::object pose_or_none(const PoseEstimate& self) {
  if (!self.has_pose) return py::none();
  return array_of(self.T_map_base);
}

py::object place_or_none(const PoseEstimate& self) {
  if (self.place.storey.empty()) return py::none();
  return py::cast(self.place);
}

void bind_place(py::module_& module) {
  py::class_<PlaceInBuilding>(module, "Place", "Where a pose is, in a map of several storeys.")
      .def_readonly("building", &PlaceInBuilding::building, "Id of the building; empty: not said.")
      .def_readonly("storey", &PlaceInBuilding::storey, "Id of the storey.")
      .def_property_readonly(
          "pose", [](const PlaceInBuilding& self) { return array_of(self.T_storey_base); },
          "x, y [m], heading [rad] of the robot in the storey's own frame; shape (3,).")
      .def("__repr__", [](const PlaceInBuilding& self) {
        return "<opal.Place " + (self.building.empty() ? "" : self.building + ", ") + self.storey + ": " +
               benchmark::pose_words(self.T_storey_base) + ">";
      });
}

void bind_pose_estimate(py::module_& module) {
  py::class_<PoseEstimate>(module, "Estimate", "Where the robot is, as far as known.")
      .def_readonly("stamp_s", &PoseEstimate::stamp_s)
      .def_property_readonly(
          "status", [](const PoseEstimate& self) { return name_of(self.status); },
          "\"searching\", \"ambiguous\", \"localized\" or \"lost\".")
      .def_property_readonly("is_localized", [](const PoseEstimate& self) { return self.status == Status::localized; })
      .def_property_readonly(
          "pose", &pose_or_none,
          "x, y [m], heading [rad] of the robot in the map, by the best hypothesis; shape (3,). None: "
          "there is no hypothesis.")
      .def_property_readonly("place", &place_or_none,
                             "Building, storey and pose on it; None: the map holds no storeys, or there is no pose.")
      .def_property_readonly(
          "covariance", [](const PoseEstimate& self) { return array_of(self.covariance); },
          "Of x, y, heading [m, m, rad], if the best hypothesis is right; shape (3, 3).")
      .def_readonly("probability", &PoseEstimate::probability,
                    "That the robot is here: the sum over all hypotheses within 0.7 m and 0.2 rad of the best one.")
      .def_readonly("none", &PoseEstimate::none, "Probability that no hypothesis is right.")
      .def_readonly("hypotheses", &PoseEstimate::hypotheses, "Number that are alive.")
      .def_readonly("alternatives", &PoseEstimate::alternatives, "Other places, most probable first.")
      .def("__repr__", [](const PoseEstimate& self) {
        return std::string("<opal.Estimate ") + name_of(self.status) +
               (self.has_pose ? ": " + benchmark::pose_words(self.T_map_base) : "") + ">";
      });
}

void bind_alternative(py::module_& module) {
  using Alternative = PoseEstimate::Alternative;
  py::class_<Alternative>(module, "Alternative", "Another place that explains what was seen.")
      .def_property_readonly("hypothesis", [](const Alternative& self) { return self.hypothesis.number(); })
      .def_property_readonly(
          "pose", [](const Alternative& self) { return array_of(self.T_map_base); },
          "Of the robot in the map; shape (3,).")
      .def_readonly("probability", &Alternative::probability,
                    "That the robot is there: the sum over all hypotheses of that place.");
}

IntArray pairs_of(const Hypothesis& hypothesis) {
  IntArray pairs({static_cast<py::ssize_t>(hypothesis.associations.size()), py::ssize_t{2}});
  int* out = pairs.mutable_data();
  for (const Association& pair : hypothesis.associations) {
    *out++ = pair.local_feature.number();
    *out++ = pair.map_feature.number();
  }
  return pairs;
}

void bind_hypothesis(py::module_& module) {
  py::class_<HypothesisHandle>(module, "Hypothesis", "One answer to \"where am I\".")
      .def_property_readonly("id", [](const HypothesisHandle& self) { return self.hypothesis.id.number(); })
      .def_property_readonly(
          "pose", [](const HypothesisHandle& self) { return array_of(self.T_map_base); },
          "Of the robot in the map, at the newest keyframe; shape (3,).")
      .def_property_readonly(
          "T_map_local", [](const HypothesisHandle& self) { return array_of(self.hypothesis.T_map_local); },
          "Where the local map lies in the map; shape (3,).")
      .def_property_readonly(
          "log_likelihood", [](const HypothesisHandle& self) { return self.hypothesis.log_likelihood; },
          "Evidence so far [nat], against \"all of this is clutter\".")
      .def_property_readonly(
          "associations", [](const HypothesisHandle& self) { return pairs_of(self.hypothesis); },
          "Local feature, position in Map.features (-1: not on the map); shape (N, 2).")
      .def("__repr__", [](const HypothesisHandle& self) {
        return "<opal.Hypothesis " + to_string(self.hypothesis.id) + ": " + benchmark::pose_words(self.T_map_base) +
               ">";
      });
}

void bind_association(py::module_& module) {
  py::class_<benchmark::NamedAssociation>(module, "Association",
                                          "A local feature, and what the best hypothesis takes it for.")
      .def_property_readonly("local_feature",
                             [](const benchmark::NamedAssociation& self) { return self.local_feature.number(); })
      .def_readonly("object", &benchmark::NamedAssociation::object, "The mapped object in words.")
      .def_readonly("feature", &benchmark::NamedAssociation::feature, "Id of the mapped feature.")
      .def_property_readonly("shape", [](const benchmark::NamedAssociation& self) { return kind_name(self.mapped); })
      .def_property_readonly(
          "seen",
          [](const benchmark::NamedAssociation& self) {
            return array_of(std::span<const double>(numbers_of(self.local)));
          },
          "The local feature in the map frame; numbers as MapFeature.numbers.")
      .def_property_readonly(
          "mapped",
          [](const benchmark::NamedAssociation& self) {
            return array_of(std::span<const double>(numbers_of(self.mapped)));
          },
          "The mapped feature; numbers as MapFeature.numbers.")
      .def_readonly("off_m", &benchmark::NamedAssociation::off_m, "Distance of the two.")
      .def("__repr__", [](const benchmark::NamedAssociation& self) {
        return "<opal.Association: local feature " + to_string(self.local_feature) + " is " + self.object + ">";
      });
}

}  // namespace

void bind_estimate(py::module_& module) {
  bind_alternative(module);
  bind_place(module);
  bind_pose_estimate(module);
  bind_hypothesis(module);
  bind_association(module);
}

}  // namespace opal::python
