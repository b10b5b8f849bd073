#pragma once

#include "benchmark/experiments/kit/localized_time.hpp"
#include "simulation/drives/faults.hpp"

#include <opal/deployment/deployment.hpp>

#include <optional>
#include <string>
#include <vector>

namespace opal::experiments {

/// What goes wrong in a drive: with its streams, or with what the robot was told.
struct Trouble {
  std::string name;
  simulation::Fault fault = simulation::Fault::none;
  bool is_laser_turned = false;  ///< the description has the laser backwards, by 180 degrees
  bool is_other_map = false;     ///< the map is another building's
  double duration_s = 10;        ///< of the fault
  std::string named = {};        ///< a word that health must say while it lasts; empty: nothing has to be said
};
/// All troubles, "none" first.
const std::vector<Trouble>& all_troubles();

/// How drives look.
struct FaultDriveOptions {
  double duration_s = 90;
  double fault_from_s = 40;
  int people = 2;
};

/// What became of one drive.
struct FaultRun {
  std::string trouble;
  std::uint64_t seed = 0;
  std::string building;                          ///< its kind
  bool localized_before = false;                 ///< when the fault began
  std::optional<double> recovered_after_s = {};  ///< after the end of the fault: localized where the robot is
  LocalizedTime localized = {};                  ///< where the robot was, and elsewhere
  bool is_named = false;                         ///< health said what was wrong
  int answers = 0;
  double worst_latency_s = 0;  ///< from arrival to answer, by the clock of the drive
};

/// One drive through a building of that seed, through the core of a live localizer.
/// @param deployment  whose lasers are simulated; a laser leaves its place only where the trouble says so.
FaultRun run_drive(const Deployment& deployment, const PluginRegistry& registry, const Trouble& trouble,
                   std::uint64_t seed, const FaultDriveOptions& options);

}  // namespace opal::experiments
