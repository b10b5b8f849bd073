#pragma once

#include "benchmark/ab/documents/cell_plan.hpp"
#include "benchmark/ab/records/journal.hpp"

namespace opal::ab {

/// How cells are computed. A worker enters the world of a task; child processes of it set an arm up there, and children
/// of these run one query each: whatever an arm does, the next cell begins with the same memory.
class CellRunner {
 public:
  virtual ~CellRunner() = default;

  /// Makes ready what the robots of a task are given: map, log, truth. @throws Error if it cannot be had.
  virtual void enter(const Task& task) = 0;
  /// Digest of what the robot is given for a task of this world.
  virtual std::string input(const Task& task) const = 0;
  /// Sets an arm up in this world. May throw, crash or hang.
  virtual void set_up(std::size_t arm) = 0;
  /// Localizes from scratch with that arm, and judges: values, costs, a failure if there was one, and as `input` a
  /// digest of what else the arm was given on the way, if anything. May throw, crash or hang.
  virtual void run(const Task& task, CellResult& result) = 0;
};

/// Computes tasks, by number and of one world, by one arm; `finished` gets every result as soon as there is one.
void run_cells(CellRunner& runner, const CellPlan& plan, std::size_t arm, const std::vector<std::size_t>& tasks,
               const CellLimits& limits, const std::function<void(const CellResult&)>& finished);

}  // namespace opal::ab
