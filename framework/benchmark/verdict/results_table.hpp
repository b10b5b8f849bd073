#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace opal::statistics {

/// What one arm did with one query: a cell of an experiment.
struct ResultRow {
  std::string arm;
  std::string cluster;     ///< site, or the building of a scenario: queries of one cluster are not independent
  std::string query;       ///< unique within its cluster
  std::uint64_t seed = 0;  ///< repetitions of a query have different seeds
  /// By name of the metric. A distance that was never reached is infinite, NaN or left out.
  std::map<std::string, double> values;
  std::string failure;  ///< empty: it ran; else what happened: "crashed: signal 11", "timed out after 60 s"
};

/// In any order. Every arm has the same (cluster, query, seed).
using ResultsTable = std::vector<ResultRow>;

/// Something to compare arms by.
struct Metric {
  /// proportion: 0 or 1. distance_until: metres or seconds until something is reached; infinite if never.
  /// cost: positive; compared by its ratio.
  enum class Kind { proportion, distance_until, cost };

  std::string name;  ///< key in ResultRow::values
  Kind kind = Kind::proportion;
  bool higher_is_better = true;
  std::string unit;    ///< "m", "ms"; empty for a proportion
  std::string phrase;  ///< for the sentence: "localizes in" 96 %, "is right" 0.4 m sooner, 12 % more "CPU"; empty: made
                       ///< of the name
  /// A smaller difference is of no interest: share, unit of the distance, share of the cost; 0: 0.02, 0.5, 0.05.
  double of_interest = 0;
  bool is_measured = false;  ///< time or memory of the machine: the same program does not give the same value again
};

}  // namespace opal::statistics
