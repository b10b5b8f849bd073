#pragma once

#include "benchmark/experiments/storeys/storey_run.hpp"
#include "report/table.hpp"

#include <vector>

namespace opal::experiments {

/// A row for drives and one for rides; below each, those whose storey can hardly be told from another one, and those
/// where it can.
Table storey_table(const std::vector<StoreyRun>& runs);
/// One row a drive.
Table storey_rows(const std::vector<StoreyRun>& runs);

}  // namespace opal::experiments
