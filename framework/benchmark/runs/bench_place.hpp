#pragma once

#include "benchmark/runs/bench_site.hpp"
#include "benchmark/runs/run_record.hpp"

#include <opal/deployment/deployment.hpp>
#include "evaluation/site.hpp"

#include <vector>

namespace opal::benchmark {

/// One recorded place with its map, ready to be run.
struct BenchPlace {
  BenchSite site;
  opal::Deployment deployment;  ///< with the laser of the recording
  std::vector<opal::Query> queries;
  std::vector<opal::LogRecord> records;

  /// The samples of one window.
  opal::Replay replay(const opal::Query& window) const;
};

/// Localizes from scratch in one window.
RunRecord run_query(opal::Localizer& localizer, const BenchPlace& place, const opal::Query& window,
                    const RunObserver& observer = {});

/// @throws Error naming the file that is wrong.
BenchPlace read_bench_place(const opal::PluginRegistry& registry, const BenchSite& site, opal::Deployment deployment);

}  // namespace opal::benchmark
