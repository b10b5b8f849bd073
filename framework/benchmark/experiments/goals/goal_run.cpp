#include "benchmark/experiments/goals/goal_run.hpp"

#include "benchmark/experiments/goals/goal_watch.hpp"

namespace opal::experiments {
namespace {

/// The place next to one where nothing stands.
Point free_place(const FloorGrid& floor, const Point& wanted) {
  if (const auto near = floor.nearest(wanted)) return *near;
  Point best = floor.center_of(floor.cells().front());
  for (const int cell : floor.cells())
    if ((floor.center_of(cell) - wanted).norm() < (best - wanted).norm()) best = floor.center_of(cell);
  return best;
}

Deployment deployment_for(const Contender& contender, const GoalTask& task, const LaserModel& laser) {
  Deployment deployment = with_lasers(contender.deployment, {laser});
  if (!deployment.patterns) return deployment;
  deployment.patterns->clear();
  for (const std::string& type : task.patterns)
    deployment.patterns->push_back({type, nlohmann::json::object(), "patterns of task " + task.id});
  return deployment;
}

void take_over(const DriveRecord& record, GoalRun& run) {
  run.reached = record.reached;
  run.said_so = record.said_so;
  run.time_s = record.time_s;
  run.driven_m = record.driven_m;
  run.off_goal_m = record.off_goal_m;
  run.collisions = static_cast<int>(record.collisions.size());
  run.scans = record.scans;
  run.localized_scans = record.localized_scans;
  run.false_scans = record.falsely_localized_scans;
  run.localized_after_m = record.localized_after_m.value_or(kNever);
  run.localized_after_s = record.localized_after_s.value_or(kNever);
}

}  // namespace

GoalRun run_task(const GoalExperiment& experiment, const PluginRegistry& registry, const Contender& contender,
                 const GoalTask& task, std::uint64_t seed) {
  simulation::Simulation simulation(experiment.map, experiment.world, world_seed(task, seed));
  simulation.place({free_place(simulation.floor(), task.start.position()), task.start.heading_rad()});
  const LocalizerParts parts =
      build_parts(deployment_for(contender, task, experiment.world.laser), registry, experiment.map);
  Localizer localizer(parts);
  const FloorGrid floor =
      navigation::mapped_floor(*parts.map, 0.8 * experiment.world.robot_radius_m, experiment.world.outdoors);
  GoalRun run;
  run.contender = contender.name;
  run.task = task.id;
  run.seed = seed;
  run.start = simulation.T_map_base();
  run.goal = free_place(simulation.floor(), task.goal);
  GoalWatch watch(simulation, localizer, task.pattern_size, run);
  const auto tree = watch.watched_tree(experiment.trees, contender.behaviour);
  take_over(drive_to_goal(simulation, localizer, floor, *tree, run.goal, experiment.loop), run);
  watch.finish();
  return run;
}

}  // namespace opal::experiments
