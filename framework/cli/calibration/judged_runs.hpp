#pragma once

#include "evaluation/calibration.hpp"
#include "evaluation/pose_tolerance.hpp"

#include <string>
#include <vector>

namespace opal::cli {

/// What bench runs said, beside the truth.
struct JudgedRuns {
  std::size_t runs = 0, queries = 0, rows = 0;
  std::size_t flagged_rows = 0, false_rows = 0;        ///< rows that are `localized`, and wrong
  std::size_t flagged_queries = 0, false_queries = 0;  ///< queries with such a row
  std::vector<Statement> best;                         ///< the best place is right
  std::vector<Statement> places;                       ///< a place is right: the best one and every alternative
  std::vector<Statement> none;                         ///< neither the best place nor any alternative is right

  /// Reads one folder that `opal bench` wrote. Rows at times without truth are left out.
  /// @param truth  folder of SITE.gt.csv; empty: where the run's recording was.
  /// @param tolerance  how far off a pose may be.
  /// @throws Error naming the file: no run, no row, no probabilities, no truth.
  void add(const std::string& run, const std::string& truth, const PoseTolerance& tolerance);

  double share_of_queries_with_false_flag() const {
    return queries ? static_cast<double>(false_queries) / static_cast<double>(queries) : 0;
  }
};

}  // namespace opal::cli
