#pragma once

#include "benchmark/runs/bench_place.hpp"
#include "evaluation/ground_truth.hpp"
#include "python/run.hpp"

#include <optional>
#include <string>
#include <vector>

namespace opal::python {

/// All queries of a recorded place, and what they are judged by.
struct BenchResult {
  std::string name;
  std::vector<Query> queries;
  RunRecord run;
  std::optional<GroundTruth> truth;  ///< none: it is not recorded
};

}  // namespace opal::python
