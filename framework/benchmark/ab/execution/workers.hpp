#pragma once

#include "benchmark/ab/execution/cell_runner.hpp"
#include "benchmark/ab/records/result_folder.hpp"

namespace opal::ab {

/// How far the work is.
struct WorkProgress {
  std::size_t before = 0;  ///< cells that were finished when it began
  std::size_t done = 0;    ///< since then
  std::size_t all = 0;
  double elapsed_s = 0;

  double share() const { return all == 0 ? 1 : static_cast<double>(before + done) / static_cast<double>(all); }
  double left_s() const {
    return done == 0 ? 0 : elapsed_s * static_cast<double>(all - before - done) / static_cast<double>(done);
  }
};

/// Computes the cells of a shard that are not finished, in several processes.
/// @param progress  is told a few times a second.
/// @throws Error if somebody else computes some of these cells, or the world of a task cannot be had. What is finished
/// stays.
void compute(CellRunner& runner, const CellPlan& plan, const ResultFolder& folder, const CellLimits& limits,
             const Shard& shard, std::size_t jobs, const std::function<void(const WorkProgress&)>& progress);

}  // namespace opal::ab
