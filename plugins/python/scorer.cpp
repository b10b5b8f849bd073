#include "scorer.hpp"

#include "interpreter.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace py = pybind11;

namespace {

using Doubles = py::array_t<double>;
using Hypotheses = std::span<const opal::Hypothesis* const>;

Doubles table(std::size_t rows, std::size_t columns) {
  return Doubles({static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(columns)});
}

double* put(double* out, const opal::Pose2& pose) {
  *out++ = pose.x();
  *out++ = pose.y();
  *out++ = pose.heading_rad();
  return out;
}

py::list associations_of(Hypotheses hypotheses) {
  py::list all;
  for (const opal::Hypothesis* hypothesis : hypotheses) {
    py::array_t<int> pairs({static_cast<py::ssize_t>(hypothesis->associations.size()), py::ssize_t{2}});
    int* out = pairs.mutable_data();
    for (const opal::Association& pair : hypothesis->associations) {
      *out++ = pair.local_feature.number();
      *out++ = pair.map_feature.number();
    }
    all.append(pairs);
  }
  return all;
}

/// opal.plugin.Hypotheses of these.
py::object hypotheses_for_python(Hypotheses hypotheses, const opal::Pose2& T_local_base, bool with_associations) {
  Doubles poses = table(hypotheses.size(), 3), frames = table(hypotheses.size(), 3);
  double *pose = poses.mutable_data(), *frame = frames.mutable_data();
  for (const opal::Hypothesis* hypothesis : hypotheses) {
    pose = put(pose, hypothesis->T_map_local * T_local_base);
    frame = put(frame, hypothesis->T_map_local);
  }
  return host_module().attr("Hypotheses")(poses, frames, with_associations ? associations_of(hypotheses) : py::list());
}

/// opal.plugin.Observation: scans after scans.
py::object observation_for_python(const opal::Observation& observation) {
  const std::size_t count = observation.points();
  Doubles points = table(count, 2), lasers = table(observation.scans.size(), 2);
  py::array_t<int> scans(static_cast<py::ssize_t>(count));
  py::list free_bearings, range_max;
  double *point = points.mutable_data(), *laser = lasers.mutable_data();
  int *scan = scans.mutable_data(), number = 0;
  for (const opal::ObservedScan& seen : observation.scans) {
    for (const opal::Point& p : seen.points) {
      *point++ = p.x();
      *point++ = p.y();
      *scan++ = number;
    }
    *laser++ = seen.laser_position.x();
    *laser++ = seen.laser_position.y();
    free_bearings.append(
        Doubles(static_cast<py::ssize_t>(seen.free_bearings_rad.size()), seen.free_bearings_rad.data()));
    range_max.append(seen.range_max_m);
    ++number;
  }
  return host_module().attr("Observation")(points, scans, lasers, free_bearings, range_max,
                                           py::cast(observation.features));
}

struct Answer {
  std::vector<double> nats;
  std::map<std::string, std::vector<double>> breakdown;
  std::vector<std::string> vetoes;
};

Answer answer_of(const PythonObject& object, Hypotheses hypotheses, const opal::Observation& observation,
                 const opal::MapView& map, bool with_associations) {
  return in_python([&] {
    const py::object said = object.attribute("score")(
        hypotheses_for_python(hypotheses, observation.local_map.T_local_base(), with_associations),
        observation_for_python(observation), py::cast(&map, py::return_value_policy::reference));
    const py::tuple checked = host_module().attr("checked_scores")(object.get(), said, hypotheses.size());
    return Answer{checked[0].cast<std::vector<double>>(), checked[1].cast<std::map<std::string, std::vector<double>>>(),
                  checked[2].cast<std::vector<std::string>>()};
  });
}

}  // namespace

PythonScorer::PythonScorer(const nlohmann::json& options) : object_(options, "score") {
  in_python(
      [&] { judges_associations_ = py::bool_(py::getattr(object_.get(), "judges_associations", py::bool_(false))); });
}

std::vector<opal::Score> PythonScorer::score_all(Hypotheses hypotheses, const opal::Observation& observation,
                                                 const opal::MapView& map) const {
  if (hypotheses.empty()) return {};
  Answer answer = answer_of(object_, hypotheses, observation, map, judges_associations_);
  std::vector<opal::Score> scores(hypotheses.size());
  for (std::size_t k = 0; k < scores.size(); ++k) {
    scores[k].log_likelihood = answer.nats[k];
    if (!answer.vetoes.empty()) scores[k].veto = std::move(answer.vetoes[k]);
    for (const auto& [name, values] : answer.breakdown) scores[k].breakdown.push_back({name, values[k]});
  }
  return scores;
}

opal::Score PythonScorer::score(const opal::Hypothesis& hypothesis, const opal::Observation& observation,
                                const opal::MapView& map, const opal::ScorerMemory*) const {
  const opal::Hypothesis* only = &hypothesis;
  return score_all({&only, 1}, observation, map).front();
}
