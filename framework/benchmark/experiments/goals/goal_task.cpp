#include "benchmark/experiments/goals/goal_task.hpp"

#include <fmt/format.h>

namespace opal::experiments {

std::vector<GoalTask> thesis4_tasks() {
  const Point goal(13, 8.5);
  const std::vector<Pose2> starts{{23.5, 12.8, 3.0},  {4.5, 2.2, 0.6},  {29.0, 2.6, 1.6},
                                  {36.5, 13.2, -1.9}, {49.5, 5.6, 0.2}, {67.0, 6.8, 2.8}};
  std::vector<GoalTask> tasks;
  for (const char set : {'A', 'B'})
    for (std::size_t route = 0; route < starts.size(); ++route) {
      GoalTask task{fmt::format("{}{}", set, route + 1), {"opal:ColumnPair"}, 2, starts[route], goal};
      if (set == 'B') {
        task.patterns = {"opal:LShape", "opal:Collinear"};
        task.pattern_size = 3;
      }
      tasks.push_back(std::move(task));
    }
  return tasks;
}

std::uint64_t world_seed(const GoalTask& task, std::uint64_t seed) {
  // FNV-1a of the task's name, so that no two tasks of a seed have the same world.
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : task.id) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash ^ (seed * 0x9e3779b97f4a7c15u);
}

}  // namespace opal::experiments
