#pragma once

#include "benchmark/experiments/goals/goal_task.hpp"
#include "benchmark/experiments/kit/contender.hpp"
#include "benchmark/experiments/kit/judged_moment.hpp"
#include "benchmark/experiments/kit/order_statistics.hpp"

#include "closed_loop/closed_loop.hpp"

#include <string>
#include <vector>

namespace opal::experiments {

/// What became of one drive to a goal: the measures of Hendrikx (2023), table 4.1, and what a simulator knows
/// besides. Times since switching on; `kNever`: it did not happen.
struct GoalRun {
  std::string contender, task;
  std::uint64_t seed = 0;
  bool reached = false;  ///< it says so, and is there
  bool said_so = false;
  double time_s = 0, driven_m = 0, off_goal_m = 0;
  int collisions = 0;  ///< steps that would have touched something
  int scans = 0, localized_scans = 0, false_scans = 0;
  double localized_after_m = kNever, localized_after_s = kNever;  ///< and right
  std::string pattern;               ///< B, L or C: what the first correct start came from; "" if it was not of columns
  double right_after_s = kNever;     ///< until some hypothesis was right: the first correct pattern
  int circles = 0, candidates = 0;   ///< in the local map then: stable ones, and all
  int wrong_starts = 0;              ///< hypotheses came up, and none was right before all had gone
  int places_after_inspection = -1;  ///< places that were left when it first set out for the goal; -1: never did
  int places_at_end = 0;
  int recoveries = 0;  ///< all hypotheses had gone, or the robot backed off
  Pose2 start;         ///< T_map_base, truly
  Point goal = Point::Zero();
  std::vector<JudgedMoment> moments;  ///< by scan
  struct Start {
    Point from;                   ///< where the robot was, frame `map`
    std::vector<Point> features;  ///< of the pattern, frame `map`, as seen from there
    bool right;
  };
  std::vector<Start> starts;  ///< of hypotheses out of nothing
};

/// What all runs of an experiment have in common.
struct GoalExperiment {
  std::shared_ptr<const SemanticMap> map;
  simulation::SimulationOptions world;
  ClosedLoopOptions loop;
  std::string trees;  ///< document of behaviour trees
};

/// One drive; may be called from several threads. @throws as build_parts, read_tree and Simulation do.
GoalRun run_task(const GoalExperiment& experiment, const PluginRegistry& registry, const Contender& contender,
                 const GoalTask& task, std::uint64_t seed);

}  // namespace opal::experiments
