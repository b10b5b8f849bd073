#pragma once

#include "benchmark/runs/bench_place.hpp"
#include "evaluation/ground_truth.hpp"
#include "python/run.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace opal::python {

/// All queries of a recorded place, and what they are judged by.
struct BenchResult {
  std::string name;
  std::vector<Query> queries;
  benchmark::RunRecord run;
  std::optional<GroundTruth> truth;            ///< none: it is not recorded
  std::map<std::string, int> plugin_failures;  ///< calls that were skipped, by type name
};

}  // namespace opal::python
