#pragma once

#include "benchmark/experiments/faults/fault_run.hpp"
#include "report/table.hpp"

#include <vector>

namespace opal::experiments {

/// One row a trouble, in the order of all_troubles().
Table fault_table(const std::vector<FaultRun>& runs);
/// One row a drive.
Table fault_rows(const std::vector<FaultRun>& runs);

}  // namespace opal::experiments
