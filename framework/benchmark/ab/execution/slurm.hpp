#pragma once

#include "benchmark/ab/records/result_folder.hpp"

#include <map>
#include <optional>

namespace opal::ab {

/// A job array under Slurm that computes the shards of an experiment.
struct SlurmJob {
  std::string id;         ///< as sbatch gives it
  std::size_t tasks = 0;  ///< of the array: shard K of `tasks` is its task K
};

/// What the tasks of a job array run: everything by its whole path, as they start elsewhere.
struct SlurmRequest {
  std::string name;                      ///< of the job
  std::string program, experiment, out;  ///< `opal`, and what `opal ab work` takes
  std::size_t tasks = 1;
  std::vector<std::string> options;  ///< further ones for sbatch: "--partition=long"
};

/// Hands the job array to sbatch and remembers it in the folder. @throws Error with what sbatch complains.
SlurmJob submit(const ResultFolder& folder, const SlurmRequest& request);

/// The newest job array of a folder; nullopt: none was submitted from there.
std::optional<SlurmJob> submitted_job(const ResultFolder& folder);

/// How many tasks of the array are in each state that Slurm still knows of: {"PENDING", 3}. Empty: none is waiting or
/// running any more. @throws Error if squeue is not there, or cannot reach its server.
std::map<std::string, std::size_t> task_states(const SlurmJob& job);

}  // namespace opal::ab
