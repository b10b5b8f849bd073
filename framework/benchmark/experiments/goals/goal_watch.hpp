#pragma once

#include "benchmark/experiments/goals/goal_run.hpp"

#include "navigation/node_registry.hpp"

namespace opal::experiments {

/// Looks on while a tree drives a robot, and writes down what table 4.1 asks. Changes nothing.
class GoalWatch {
 public:
  /// All must outlive this.
  GoalWatch(const simulation::Simulation& simulation, const Localizer& localizer, int pattern_size, GoalRun& run)
      : simulation_(simulation), localizer_(localizer), pattern_size_(pattern_size), run_(run) {}

  /// A tree of the document that tells this what it does.
  std::unique_ptr<navigation::Node> watched_tree(const std::string& trees, const std::string& name);
  /// After the drive.
  void finish();

 private:
  void look(const navigation::Blackboard& blackboard);
  void look_at_hypotheses(const navigation::Blackboard& blackboard);
  void note_start(const navigation::Blackboard& blackboard, bool right);
  void note_right(const navigation::Blackboard& blackboard);

  const simulation::Simulation& simulation_;
  const Localizer& localizer_;
  int pattern_size_;
  GoalRun& run_;
  bool under_way_ = false;  ///< to the goal, at this tick
  bool had_pose_ = false;   ///< at the tick before
  bool right_since_start_ = false;
};

}  // namespace opal::experiments
