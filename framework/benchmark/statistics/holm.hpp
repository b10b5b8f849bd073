#pragma once

#include <span>
#include <vector>

namespace opal::statistics {

/// p-values corrected for their number (Holm 1979): where those below a level are taken for true, the chance that any
/// of them is not is at most that level, however they depend on each other. Same order; NaN is not counted and stays
/// NaN.
std::vector<double> holm(std::span<const double> p_values);

}  // namespace opal::statistics
