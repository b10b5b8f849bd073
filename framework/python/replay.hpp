#pragma once

#include "benchmark/runs/recorded_log.hpp"

#include <opal/sensing/replay.hpp>

#include <memory>
#include <vector>

namespace opal::python {

/// A replay, with the records that it walks.
struct ReplayHandle {
  std::shared_ptr<const benchmark::RecordedLog> log;
  std::vector<LaserModel> lasers;
  Replay replay;
};

}  // namespace opal::python
