#pragma once

#include "benchmark/verdict_page/report_page.hpp"

#include <string>

namespace opal::statistics {

/// Writes what the page shows into a folder, for papers: tables as CSV, Markdown and LaTeX, plots as SVG and PDF. The
/// names of files are those of arms, baseline and metrics.
///
///     ARM_BASELINE.csv               the summary: a row per metric
///     ARM_BASELINE_numbers.csv       every number behind the verdict: a column per metric
///     ARM_BASELINE_METRIC_sites.csv, .svg  differences by site; a metric in which no pair differs has none
///     ARM_BASELINE_METRIC_pairs.csv, .svg  the pairs that differ, most first; the picture of a distance or a cost
///
/// @throws WriteError naming the file.
void write_paper(const ReportPage& page, const std::string& folder);

}  // namespace opal::statistics
