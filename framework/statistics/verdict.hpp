#pragma once

#include "statistics/results_table.hpp"

namespace opal::statistics {

/// What an experiment says of one arm beside the baseline.
struct Verdict {
  std::string arm, baseline;
  std::string sentence;  ///< what the numbers carry, in words
};

}  // namespace opal::statistics
