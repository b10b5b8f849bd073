#pragma once

#include <opal/deployment/deployment.hpp>
#include "map_tools/test_maps/map_damage.hpp"

#include "simulation/buildings/building.hpp"
#include "simulation/drives/recording.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace opal::ab {

/// One way to localize that takes part.
struct Arm {
  std::string name;
  nlohmann::json configuration;             ///< the deployment's document, with the arm's overrides
  Deployment deployment;                    ///< the same, read
  std::vector<std::string> plugin_folders;  ///< beside the program's own, for this arm only
};

/// Windows of a recorded place.
struct RecordedPlace {
  std::string prefix;                ///< of its files, as opal bench takes it
  std::vector<std::string> queries;  ///< of its windows, only these; empty: all
};

/// Drives through a building that nobody has driven through.
struct SimulatedDrives {
  std::string map;                                      ///< file; empty: the building is made
  std::optional<simulation::BuildingRequest> building;  ///< what to make
  std::optional<std::string> challenge;                 ///< of Hendrikx (2023), 3.5.2: its way, its clutter, its people
  double duration_s = 60;                               ///< of a challenge
  simulation::SimulationOptions world;
  simulation::DriveOptions drives;  ///< without a challenge
};

/// Something to localize in. What a seed changes: noise, clutter, people and starts of simulated drives; damage.
struct Scenario {
  std::string name;
  std::variant<RecordedPlace, SimulatedDrives> source;
  std::string damage;  ///< words of read_map_damage; a recording's map, or the simulated building against its map
  std::vector<std::uint64_t> seeds;
};

/// What a cell may take. More is a failure of its arm.
struct CellLimits {
  double wall_s = 300;
  double memory_mb = 4000;
};

/// What is to be compared, and on what: docs/compare_scorers.md explains the document.
struct Experiment {
  std::string file;
  std::string name;
  nlohmann::json document;  ///< as written
  std::vector<Arm> arms;
  std::size_t baseline = 0;  ///< of `arms`
  bool observes = false;     ///< the baseline's scorers decide in every arm; an arm's own judge the same hypotheses
  std::vector<Scenario> scenarios;
  std::vector<std::string> metrics;  ///< to be judged, the one that decides first; empty: the usual ones
  int looks = 1;                     ///< how often one may look before all cells are done
  CellLimits limits;
};

/// Reads an experiment strictly, and the deployments that it names.
/// @param shipped  finds the file of a configuration that ships with the program, by name.
/// @throws ConfigError "my.jsonld: /arms/1/name: \"a\", expected a name that no other arm has"; also if two arms are
/// not given the same map, overlays, importers and sensor.
Experiment read_experiment(const std::string& path, const std::function<std::string(const std::string&)>& shipped);

}  // namespace opal::ab
