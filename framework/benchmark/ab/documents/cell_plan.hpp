#pragma once

#include "benchmark/ab/documents/experiment.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace opal::ab {

/// A query of a scenario with a seed: what every arm is given alike.
struct Task {
  std::size_t scenario = 0;  ///< position in Experiment::scenarios
  std::uint64_t seed = 0;
  std::size_t query = 0;  ///< position in the scenario's queries

  bool same_world(const Task& other) const { return scenario == other.scenario && seed == other.seed; }
};

/// A task by one arm: one localization from scratch, which is computed on its own.
struct Cell {
  Task task;
  std::size_t arm = 0;  ///< position in Experiment::arms
};

/// All cells of an experiment, by number: scenario by scenario, seed by seed, query by query, arm by arm. Nothing is
/// stored per cell.
class CellPlan {
 public:
  /// @param queries  names, per scenario. @throws ConfigError if there is none.
  CellPlan(const Experiment& experiment, std::vector<std::vector<std::string>> queries);

  std::size_t tasks() const { return first_task_.back(); }
  std::size_t cells() const { return tasks() * arms_.size(); }
  Task task(std::size_t number) const;
  Cell cell(std::size_t number) const { return {task(number / arms_.size()), number % arms_.size()}; }
  std::size_t arms() const { return arms_.size(); }

  const std::string& query(const Task& task) const { return scenarios_[task.scenario].queries[task.query]; }
  const std::string& scenario(const Task& task) const { return scenarios_[task.scenario].name; }
  const std::string& arm(const Cell& cell) const { return arms_[cell.arm]; }
  /// "office/q01/7/lack_of_fit": scenario, query, seed, arm.
  std::string name(const Cell& cell) const;

  /// Tasks [first, last) that one worker takes at once: of one world, and few where worlds are few.
  std::size_t end_of_block(std::size_t first, std::size_t last) const;

 private:
  struct Tasks {
    std::string name;
    std::vector<std::uint64_t> seeds;
    std::vector<std::string> queries;
  };
  std::vector<Tasks> scenarios_;
  std::vector<std::size_t> first_task_;  ///< of each scenario, and the number of all
  std::vector<std::string> arms_;
};

/// One of several equal parts of an experiment's tasks, for job arrays.
struct Shard {
  std::size_t number = 1, of = 1;

  std::size_t first(std::size_t tasks) const { return (number - 1) * tasks / of; }
  std::size_t end(std::size_t tasks) const { return number * tasks / of; }
  std::string name() const { return std::to_string(number) + "-of-" + std::to_string(of); }
};

/// Reads "3/10". @throws ConfigError saying what was expected.
Shard read_shard(const std::string& text);

}  // namespace opal::ab
