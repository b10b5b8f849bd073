#pragma once

#include "benchmark/ab/records/result_folder.hpp"
#include "benchmark/bundle/bundle.hpp"

namespace opal::ab {

/// How a repeated experiment differs from the one of a bundle, in sentences.
struct RepeatedVerdict {
  std::vector<std::string> made_with;  ///< other versions and files than then
  std::vector<std::string> cells;      ///< the number of cells that came out differently, and the first ones
  std::vector<std::string> verdict;    ///< outcomes that differ, and numbers of metrics that do not measure a cost
  std::vector<std::string> costs;      ///< measured costs then and now

  bool same() const { return verdict.empty(); }
};

/// Compares a bundle's results with those of a folder. Costs are measured anew, and never twice the same: of them, only
/// the outcome must be the same.
/// @throws Error naming the file if results cannot be read.
RepeatedVerdict compare_with(const Bundle& bundle, const ResultFolder& repeated);

}  // namespace opal::ab
