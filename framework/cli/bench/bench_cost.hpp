#pragma once

#include "benchmark/runs/run_record.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace opal::cli {

/// What a run is measured by, besides its results.
struct BenchCost {
  std::size_t queries = 0;
  double import_s = 0;
  double localizer_mb = 0;  ///< what the map's indices take
};

/// Heap of this process now [MB].
double allocated_mb();

/// Counts, CPU time and memory of a run, as summary.json has them.
nlohmann::ordered_json summarize(const benchmark::RunRecord& all, const BenchCost& cost);

/// The costs of a summary for people, one line.
std::string cost_text(const nlohmann::ordered_json& summary);

}  // namespace opal::cli
