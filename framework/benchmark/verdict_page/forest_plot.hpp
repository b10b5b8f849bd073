#pragma once

#include "benchmark/verdict/verdict.hpp"

namespace opal::statistics {

/// SVG: one row per cluster with its difference and interval, and all together at the bottom (Lewis & Clarke 2001).
/// Shares in points, costs as ratios on a logarithmic axis.
std::string forest_plot(const MetricResult& result, const std::string& arm, const std::string& baseline);

}  // namespace opal::statistics
