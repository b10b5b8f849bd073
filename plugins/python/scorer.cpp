#include "scorer.hpp"

#include "interpreter.hpp"
#include "memory.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace opal::python_classes {

namespace py = pybind11;

namespace {

using Doubles = py::array_t<double>;
using Hypotheses = std::span<const Hypothesis* const>;
using Memories = std::span<const ScorerMemory* const>;

Doubles table(std::size_t rows, std::size_t columns) {
  return Doubles({static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(columns)});
}

double* put(double* out, const Pose2& pose) {
  *out++ = pose.x();
  *out++ = pose.y();
  *out++ = pose.heading_rad();
  return out;
}

py::list associations_of(Hypotheses hypotheses) {
  py::list all;
  for (const Hypothesis* hypothesis : hypotheses) {
    py::array_t<int> pairs({static_cast<py::ssize_t>(hypothesis->associations.size()), py::ssize_t{2}});
    int* out = pairs.mutable_data();
    for (const Association& pair : hypothesis->associations) {
      *out++ = pair.local_feature.number();
      *out++ = pair.map_feature.number();
    }
    all.append(pairs);
  }
  return all;
}

/// opal.plugin.Hypotheses of these. Their memories are null, and left out, for a class that remembers nothing.
py::object hypotheses_for_python(Hypotheses hypotheses, Memories memories, const Observation& observation,
                                 bool with_associations) {
  Doubles poses = table(hypotheses.size(), 3), frames = table(hypotheses.size(), 3);
  double *pose = poses.mutable_data(), *frame = frames.mutable_data();
  for (const Hypothesis* hypothesis : hypotheses) {
    pose = put(pose, observation.T_map_base(hypothesis->T_map_local));
    frame = put(frame, hypothesis->T_map_local);
  }
  py::list states;
  for (const ScorerMemory* memory : memories)
    if (memory != nullptr) states.append(state_of(*memory));
  return host_module().attr("Hypotheses")(poses, frames, with_associations ? associations_of(hypotheses) : py::list(),
                                          states);
}

/// opal.plugin.Observation: scans after scans.
py::object observation_for_python(const Observation& observation) {
  const std::size_t count = observation.points();
  Doubles points = table(count, 2), lasers = table(observation.scans.size(), 2);
  py::array_t<int> scans(static_cast<py::ssize_t>(count));
  py::list free_bearings, range_max;
  double *point = points.mutable_data(), *laser = lasers.mutable_data();
  int *scan = scans.mutable_data(), number = 0;
  for (const ObservedScan& seen : observation.scans) {
    for (const Point& p : seen.points) {
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
  std::vector<std::shared_ptr<const ScorerMemory>> seen;
};

std::vector<std::shared_ptr<const ScorerMemory>> seen_in(const py::list& states) {
  std::vector<std::shared_ptr<const ScorerMemory>> seen;
  for (const py::handle& state : states)
    seen.push_back(std::make_shared<PythonMemory>(py::reinterpret_borrow<py::object>(state)));
  return seen;
}

Answer answer_of(const PythonObject& object, Hypotheses hypotheses, Memories memories, const Observation& observation,
                 const MapView& map, bool with_associations) {
  return in_python([&] {
    const py::object said = object.attribute("score")(
        hypotheses_for_python(hypotheses, memories, observation, with_associations),
        observation_for_python(observation), py::cast(&map, py::return_value_policy::reference));
    const py::tuple checked = host_module().attr("checked_scores")(object.get(), said, hypotheses.size());
    return Answer{checked[0].cast<std::vector<double>>(), checked[1].cast<std::map<std::string, std::vector<double>>>(),
                  checked[2].cast<std::vector<std::string>>(), seen_in(checked[3])};
  });
}

std::vector<Score> scores_of(Answer answer, std::size_t count) {
  std::vector<Score> scores(count);
  for (std::size_t k = 0; k < count; ++k) {
    scores[k].log_likelihood = answer.nats[k];
    if (!answer.vetoes.empty()) scores[k].veto = std::move(answer.vetoes[k]);
    for (const auto& [name, values] : answer.breakdown) scores[k].breakdown.push_back({name, values[k]});
    if (!answer.seen.empty()) scores[k].seen = std::move(answer.seen[k]);
  }
  return scores;
}

}  // namespace

PythonScorer::PythonScorer(const nlohmann::json& options) : object_(options, "score") {
  in_python([&] {
    judges_associations_ = py::bool_(py::getattr(object_.get(), "judges_associations", py::bool_(false)));
    remembers_ = py::hasattr(object_.get(), "new_memory");
    fades_ = py::hasattr(object_.get(), "fade");
    if (remembers_ && !py::hasattr(object_.get(), "remember"))
      refuse(object_.type_info().name + " has new_memory, but no method remember, expected both or none");
  });
}

std::unique_ptr<ScorerMemory> PythonScorer::new_memory(const MapView& map) const {
  if (!remembers_) return nullptr;
  return in_python([&] {
    return std::make_unique<PythonMemory>(
        object_.attribute("new_memory")(py::cast(&map, py::return_value_policy::reference)));
  });
}

std::vector<Score> PythonScorer::score_all(Hypotheses hypotheses, Memories memories, const Observation& observation,
                                           const MapView& map) const {
  return scores_of(answer_of(object_, hypotheses, memories, observation, map, judges_associations_), hypotheses.size());
}

Score PythonScorer::score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
                          const ScorerMemory* memory) const {
  const Hypothesis* only = &hypothesis;
  return score_all({&only, 1}, {&memory, 1}, observation, map).front();
}

void PythonScorer::remember(ScorerMemory& memory, const ScorerMemory& seen, double weight) const {
  in_python([&] { change(memory, object_.attribute("remember")(state_of(memory), state_of(seen), weight)); });
}

void PythonScorer::fade(ScorerMemory& memory, double weight) const {
  if (fades_) in_python([&] { change(memory, object_.attribute("fade")(state_of(memory), weight)); });
}

}  // namespace opal::python_classes
