#include "cli/experiment/experiment_contenders.hpp"
#include "cli/experiment/experiment_output.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/terminal/run_end.hpp"
#include "cli/terminal/stop_signals.hpp"

#include "benchmark/experiments/goals/goal_report.hpp"
#include "benchmark/experiments/kit/in_parallel.hpp"
#include "benchmark/experiments/kit/thesis_robot.hpp"

#include "navigation/node_registry.hpp"

namespace opal::cli {
namespace {

using namespace experiments;

/// The thesis' own configurations drive as it does, others by the first tree.
std::string behaviour_of(const std::string& contender, const ExperimentOptions& options, const std::string& trees) {
  if (!options.behaviour.empty()) return options.behaviour;
  return contender.starts_with("thesis") ? "inspect" : navigation::first_tree(trees);
}

std::vector<Contender> drivers(const ExperimentOptions& options, const std::string& trees) {
  std::vector<Contender> all = contenders(options.configs);
  for (Contender& contender : all) {
    contender.behaviour = behaviour_of(contender.name, options, trees);
    navigation::read_tree(navigation::standard_nodes(), trees,
                          contender.behaviour);  // before anything is written
  }
  return all;
}

GoalExperiment setting(const ExperimentOptions& options, const PluginRegistry& registry) {
  GoalExperiment experiment{building(registry, options.map, "gemini"), thesis_robot(), {}, options.trees};
  if (experiment.trees.empty()) experiment.trees = session::shipped_config("behaviours.jsonld");
  experiment.loop.motion.radius_m = experiment.world.robot_radius_m;
  experiment.loop.most_s = options.most_s;
  return experiment;
}

std::string line_of(const GoalRun& run) {
  return run.contender + ' ' + run.task + " seed " + std::to_string(run.seed) + ": " +
         drive_ending(run.reached, run.said_so) + " after " + number(run.time_s, 0) + " s and " +
         number(run.driven_m, 1) + " m; " + std::to_string(run.collisions) + " collisions, " +
         std::to_string(run.false_scans) + " of " + std::to_string(run.scans) + " scans falsely localized\n";
}

}  // namespace

int experiment_thesis4(const ExperimentOptions& options, const PluginRegistry& registry) {
  const GoalExperiment experiment = setting(options, registry);
  const std::vector<Contender> all = drivers(options, experiment.trees);
  const std::vector<GoalTask> tasks = chosen(thesis4_tasks(), options.only);
  const StopSignals signals;
  OutputFolder folder(options.out, "opal experiment thesis4", experiment_products());
  const std::size_t each = all.size() * tasks.size();
  std::vector<std::vector<GoalRun>> parts(each * static_cast<std::size_t>(options.seeds));
  const auto run = [&](std::size_t k) {
    parts[k] = {run_task(experiment, registry, all[k % each / tasks.size()], tasks[k % tasks.size()], k / each + 1)};
    std::cerr << line_of(parts[k].front());
  };
  in_parallel(parts.size(), options.jobs, run, signals.token());
  const int signal = cut_by(signals, parts);
  const std::vector<GoalRun> runs = done(std::move(parts));
  if (runs.empty()) return end_run(folder, signal, kDone);
  write_experiment(options.out, std::span<const GoalRun>(runs), &GoalRun::task, goal_table(runs), goal_summary(runs),
                   goal_page(*experiment.map, runs));
  return end_run(folder, signal, kDone);
}

}  // namespace opal::cli
