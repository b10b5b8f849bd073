#pragma once

#include "benchmark/experiments/kit/judged_moment.hpp"
#include "report/plot.hpp"

#include <span>
#include <string>

namespace opal::experiments {

/// A run over time: error of the best hypothesis, number of hypotheses, CPU time per update if any was
/// measured, and in a bar whether it was localized (Hendrikx 2023, figure 3.10).
LinePlot lines_over_time(std::span<const JudgedMoment> moments);
/// The same as HTML; empty without moments.
std::string time_plot(std::span<const JudgedMoment> moments);

/// What the colours of that bar mean. HTML.
std::string status_key();

}  // namespace opal::experiments
