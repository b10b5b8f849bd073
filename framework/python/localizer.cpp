#include "benchmark/runs/answer.hpp"
#include "python/bindings.hpp"
#include "python/localizer_handle.hpp"
#include "python/scan.hpp"
#include "report/status_text.hpp"
#include "session/shipped_files.hpp"

#include <pybind11/stl.h>

#include <variant>

namespace opal::python {

namespace py = pybind11;

namespace {

using Handle = LocalizerHandle;

std::unique_ptr<Handle> make(const std::variant<Deployment, std::string>& deployment,
                             const std::optional<MapHandle>& map, const py::object& events) {
  const auto* name = std::get_if<std::string>(&deployment);
  return std::make_unique<Handle>(
      name != nullptr ? read_deployment(session::config_file(*name)) : std::get<0>(deployment), map, events);
}

const LaserModel& laser_of(const Handle& self, std::size_t laser) {
  const auto& lasers = self.deployment().lasers;
  if (laser < lasers.size()) return lasers[laser];
  throw std::invalid_argument("laser: " + std::to_string(laser) + ", expected one of " + std::to_string(lasers.size()) +
                              ", counted from 0");
}

std::vector<HypothesisHandle> hypotheses(Handle& self) {
  const Localizer& localizer = self.localizer();
  std::vector<HypothesisHandle> all;
  for (const Hypothesis& hypothesis : localizer.hypotheses())
    all.push_back({hypothesis, hypothesis.T_map_local * localizer.local_map().T_local_base()});
  return all;
}

std::vector<std::string> sensor_words(Handle& self) {
  std::vector<std::string> words;
  for (const SensorFinding& finding : self.localizer().sensor_findings()) words.push_back(finding.words);
  return words;
}

std::string reasons(Handle& self, const PoseEstimate& estimate) {
  return reason_text(name_of(estimate.status), self.localizer().why(), sensor_words(self));
}

py::list local_features(Handle& self) {
  using namespace py::literals;
  py::list features;
  for (const LocalFeature& local : self.localizer().local_map().features())
    features.append(py::dict("id"_a = local.id.number(), "type"_a = local.feature.type,
                             "shape"_a = kind_name(local.feature.geometry), "stable"_a = local.stable,
                             "numbers"_a = array_of(std::span<const double>(numbers_of(local.feature.geometry)))));
  return features;
}

std::map<std::string, double> times_ms(Handle& self) {
  const StageTimes& times = self.localizer().last_times();
  return {{"sensor", 1e3 * times.sensor_s},         {"detect", 1e3 * times.detect_s},
          {"local_map", 1e3 * times.local_map_s},   {"track", 1e3 * times.track_s},
          {"generate", 1e3 * times.generate_s},     {"search", 1e3 * times.search_s},
          {"retrospect", 1e3 * times.retrospect_s}, {"grow", 1e3 * times.grow_s},
          {"status", 1e3 * times.status_s}};
}

std::map<std::string, double> scores(Handle& self, int hypothesis) {
  std::map<std::string, double> nats;
  for (const auto& [name, score] : self.localizer().scores_of(HypothesisId(hypothesis)))
    nats[name] = score.log_likelihood;
  return nats;
}

void bind_steps(py::class_<Handle>& localizer) {
  localizer
      .def("update", &Handle::update, py::arg("sample"),
           "Takes what the lasers saw. Returns the estimate if the sample became a keyframe (the robot has moved or "
           "turned enough), else None. A poor scan is no error: it is a status.")
      .def(
          "update",
          [](Handle& self, const GivenRanges& ranges_m, const GivenArray& odometry, double stamp_s, std::size_t laser) {
            return self.update(sample_of_ranges(laser_of(self, laser), ranges_m, odometry, stamp_s));
          },
          py::arg("ranges_m"), py::arg("odometry"), py::arg("stamp_s"), py::arg("laser") = 0, kSampleWords)
      .def(
          "estimate_at",
          [](Handle& self, double stamp_s, const GivenArray& odometry) {
            return self.localizer().estimate_at(stamp_s, pose_of(odometry, "odometry"));
          },
          py::arg("stamp_s"), py::arg("odometry"), "The newest estimate, carried on by odometry; odometry: shape (3,).")
      .def("run", &Handle::run, py::arg("replay"), py::arg("query") = "run",
           "Resets, then plays a whole replay, as `opal localize` does. query: names the rows.")
      .def("reset", &Handle::reset, py::arg("name") = "run", "Forgets everything: the next scan is the first one.")
      .def(
          "hint",
          [](Handle& self, const GivenArray& pose, double sigma_m, double sigma_rad) {
            self.localizer().hint({pose_of(pose, "pose"), sigma_m, sigma_rad});
          },
          py::arg("pose"), py::arg("sigma_m") = 0.5, py::arg("sigma_rad") = 0.2,
          "The search looks at this pose of the robot in the map, too; scans judge it like all others.")
      .def("finish_events", &Handle::finish_events, "Everything is in the event file. Raises opal.WriteError.");
}

void bind_answers(py::class_<Handle>& localizer) {
  localizer.def_property_readonly("hypotheses", &hypotheses, "Alive, best first.")
      .def_property_readonly(
          "associations", [](Handle& self) { return benchmark::associations_of(self.localizer()); },
          "What the best hypothesis rests on.")
      .def_property_readonly(
          "why", [](Handle& self) { return self.localizer().why(); }, "Why the newest status is what it is, in words.")
      .def("reasons", &reasons, py::arg("estimate"),
           "Why an estimate is not localized, as `opal localize` says it; empty if it is.")
      .def("scores", &scores, py::arg("hypothesis"), "Newest opinion of each scorer on a hypothesis, by its id [nat].")
      .def_property_readonly("local_features", &local_features, "Features of the last metres; frame local.")
      .def_property_readonly("sensor_findings", &sensor_words,
                             "What the drive tells of the sensor description, as sentences.")
      .def_property_readonly("times_ms", &times_ms, "CPU time of the newest keyframe by stage.")
      .def_property_readonly(
          "plugin_failures", [](Handle& self) { return self.localizer().plugin_failures(); },
          "Calls into plugins that failed and were skipped, by type.")
      .def_property_readonly("deployment", [](const Handle& self) { return self.deployment(); })
      .def_property_readonly("map", [](const Handle& self) { return self.map(); });
}

}  // namespace

void bind_localizer(py::module_& module) {
  py::class_<Handle> localizer(
      module, "Localizer",
      "The localizer of one robot, step by step. One thread at a time; other threads of Python run during an update.");
  localizer.def(py::init(&make), py::arg("deployment"), py::arg("map") = py::none(), py::arg("events") = py::none(),
                "deployment: an opal.Deployment, or the name of one.\n"
                "map: an opal.Map; None: that of the deployment.\n"
                "events: a function that takes each event as a dict (docs/events.md), or the path of a file for `opal "
                "view`.\nRaises opal.Error.");
  bind_steps(localizer);
  bind_answers(localizer);
}

}  // namespace opal::python
