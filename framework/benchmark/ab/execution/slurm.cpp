#include "benchmark/ab/execution/slurm.hpp"

#include "benchmark/ab/execution/command.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "common/text_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>

namespace opal::ab {
namespace {

std::string remembered_in(const ResultFolder& folder) { return folder.file("slurm.json"); }

/// For a shell: whatever is in it stays one word.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string script_of(const SlurmRequest& request) {
  return fmt::format("#!/bin/sh\nexec {} ab work {} -o {} --shard \"$SLURM_ARRAY_TASK_ID/{}\"\n",
                     quoted(request.program), quoted(request.experiment), quoted(request.out), request.tasks);
}

/// "12" or "12;cluster".
std::string job_id(const std::string& said) {
  const std::string id = said.substr(0, said.find_first_of(";\n"));
  if (id.empty() || id.find_first_not_of("0123456789") != std::string::npos)
    throw Error("sbatch: \"" + said + "\", expected the number of a job");
  return id;
}

}  // namespace

SlurmJob submit(const ResultFolder& folder, const SlurmRequest& request) {
  const std::string script = folder.file("slurm_job.sh");
  write_text(script, script_of(request));
  std::vector<std::string> command{"sbatch", "--parsable", "--job-name=opal-ab-" + request.name,
                                   fmt::format("--array=1-{}", request.tasks),
                                   "--output=" + request.out + "/logs/slurm-%A_%a.log"};
  command.insert(command.end(), request.options.begin(), request.options.end());
  command.push_back(script);
  const SlurmJob job{job_id(output_of(command)), request.tasks};
  write_text(remembered_in(folder), nlohmann::ordered_json{{"job", job.id}, {"tasks", job.tasks}}.dump() + '\n');
  return job;
}

std::optional<SlurmJob> submitted_job(const ResultFolder& folder) {
  const std::string file = remembered_in(folder);
  if (!std::filesystem::exists(file)) return std::nullopt;
  const nlohmann::json json = read_json(file);
  return SlurmJob{json.at("job"), json.at("tasks")};
}

std::map<std::string, std::size_t> task_states(const SlurmJob& job) {
  const CommandResult result = run_command({"squeue", "--noheader", "--array", "--jobs=" + job.id, "--format=%T"});
  // Slurm forgets ended jobs after some minutes.
  if (result.exit_code != 0 && result.errors.find("Invalid job id") != std::string::npos) return {};
  if (result.exit_code != 0) throw Error("squeue: " + result.errors);
  std::map<std::string, std::size_t> states;
  std::istringstream lines(result.output);
  for (std::string state; lines >> state;) ++states[state];
  return states;
}

}  // namespace opal::ab
