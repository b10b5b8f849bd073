#pragma once

#include "benchmark/runs/bench_place.hpp"

#include "benchmark/ab/documents/experiment.hpp"

#include "simulation/drives/challenges.hpp"

#include "evaluation/ground_truth.hpp"

#include <map>

namespace opal::benchmark {

/// What robots are given for one scenario and seed, and what they are judged by.
struct World {
  BenchPlace place;  ///< with the baseline's deployment
  opal::GroundTruth truth;
  std::optional<opal::RegionPrior> region;  ///< that robots are told
  std::string digest;                       ///< of all that robots are given: map, log, laser, region

  const opal::Query& query(std::size_t position) const { return place.queries[position]; }
};

/// Makes the worlds of an experiment. Maps are read or imported once per scenario.
class WorldSource {
 public:
  WorldSource(const opal::ab::Experiment& experiment, const opal::PluginRegistry& registry)
      : experiment_(experiment), registry_(registry) {}

  /// Names of the scenario's queries; nothing is simulated for them.
  std::vector<std::string> queries(const opal::ab::Scenario& scenario) const;
  /// What a scenario's worlds are made of: digests of files and maps, by name.
  nlohmann::ordered_json inputs(const opal::ab::Scenario& scenario);
  /// The scenario's map, without damage that a seed decides.
  const std::shared_ptr<const opal::SemanticMap>& map_of(const opal::ab::Scenario& scenario);
  /// @throws opal::Error naming what cannot be used.
  World make(const opal::ab::Scenario& scenario, std::uint64_t seed);

 private:
  using Map = std::shared_ptr<const opal::SemanticMap>;
  World recorded(const opal::ab::Scenario& scenario, const opal::ab::RecordedPlace& place, std::uint64_t seed);
  World simulated(const opal::ab::Scenario& scenario, const opal::ab::SimulatedDrives& drives, std::uint64_t seed);

  const opal::ab::Experiment& experiment_;
  const opal::PluginRegistry& registry_;
  std::string of_;  ///< the scenario of `map_`
  Map map_;
  std::map<std::string, std::string> log_digests_;  ///< of recordings, by prefix
};

}  // namespace opal::benchmark
