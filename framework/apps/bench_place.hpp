#pragma once

#include "run_record.hpp"

#include <opal/deployment.hpp>
#include <opal/plugin/plugin_registry.hpp>
#include <opal/site.hpp>

#include <memory>
#include <string>
#include <vector>

/// One recorded place, ready to be run.
struct BenchPlace {
  std::string prefix;  ///< of its files
  std::string name;    ///< of the place
  opal::Deployment deployment;
  std::shared_ptr<const opal::SemanticMap> map;
  std::vector<opal::Query> queries;
  std::vector<opal::LogRecord> records;
  double import_s = 0;  ///< CPU time

  /// The samples of one window.
  opal::Replay replay(const opal::Query& window) const;
};

/// @param config  deployment to run; empty: configs/default.jsonld. @throws Error naming the file that is wrong.
BenchPlace read_bench_place(const opal::PluginRegistry& registry, const std::string& prefix, const std::string& config);

/// CPU time of the process so far.
double process_cpu_s();
