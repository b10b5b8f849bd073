#pragma once

#include "benchmark/ab/execution/slurm.hpp"
#include "benchmark/cells/ab_runner.hpp"

#include "benchmark/ab/records/result_folder.hpp"
#include "benchmark/verdict/results_table.hpp"

#include <string>
#include <vector>

namespace opal::cli {

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

  void work(const ab::Shard& shard, std::size_t jobs);
  /// Says and writes what came out. @return whether all cells are finished.
  bool collect();
  ab::SlurmJob submit(const AbOptions& options) const;
  /// @return whether all cells are finished.
  bool status() const;

  const ab::Experiment& experiment() const { return experiment_; }
  const ab::ResultFolder& folder() const { return folder_; }
  const nlohmann::ordered_json& manifest() const { return manifest_; }
  benchmark::WorldSource& worlds() { return worlds_; }

 private:
  std::vector<std::vector<std::string>> all_queries() const;

  ab::Experiment experiment_;
  std::vector<statistics::Metric> metrics_;  // a wrong name shows before hours of work
  std::vector<benchmark::ArmPlugins> plugins_;
  benchmark::WorldSource worlds_;
  ab::CellPlan plan_;
  nlohmann::ordered_json manifest_;
  ab::ResultFolder folder_;
};

}  // namespace opal::cli
