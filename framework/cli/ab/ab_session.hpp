#pragma once

#include "benchmark/ab/execution/slurm.hpp"
#include "benchmark/cells/ab_runner.hpp"

#include "benchmark/ab/records/result_folder.hpp"
#include "benchmark/verdict/results_table.hpp"

#include <string>
#include <vector>

struct AbOptions {
  std::string experiment, out, shard = "1/1";
  int jobs = 0;
  int tasks = 0;  ///< of a job array
  std::vector<std::string> sbatch;
  std::string bundle;               ///< folder
  double largest_mb = 10;           ///< of recordings that a bundle includes
  std::vector<std::string> places;  ///< with recordings that it does not
};

/// Processes that compute, if the user has not said how many: one per core.
std::size_t jobs_of(const AbOptions& options);

/// An experiment with all that its cells are computed from, and where they go.
class AbSession {
 public:
  explicit AbSession(const AbOptions& options);

  void work(const opal::ab::Shard& shard, std::size_t jobs);
  /// Says and writes what came out. @return whether all cells are finished.
  bool collect();
  opal::ab::SlurmJob submit(const AbOptions& options) const;
  /// @return whether all cells are finished.
  bool status() const;

  const opal::ab::Experiment& experiment() const { return experiment_; }
  const opal::ab::ResultFolder& folder() const { return folder_; }
  const nlohmann::ordered_json& manifest() const { return manifest_; }
  opal::benchmark::WorldSource& worlds() { return worlds_; }

 private:
  std::vector<std::vector<std::string>> all_queries() const;

  opal::ab::Experiment experiment_;
  std::vector<opal::statistics::Metric> metrics_;  // a wrong name shows before hours of work
  std::vector<opal::benchmark::ArmPlugins> plugins_;
  opal::benchmark::WorldSource worlds_;
  opal::ab::CellPlan plan_;
  nlohmann::ordered_json manifest_;
  opal::ab::ResultFolder folder_;
};
