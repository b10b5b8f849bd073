#pragma once

#include "benchmark/experiments/buildings/buildings_report.hpp"
#include "report/plot.hpp"

namespace opal::experiments {

/// One HTML file that needs no other: groups, every run that failed with a picture, and all buildings.
std::string buildings_page(const BuildingsExperiment& experiment);

/// The page's plots of all groups, for figures; by name: "default_success", "default_wrong".
std::vector<std::pair<std::string, IntervalPlot>> share_plots(const BuildingsExperiment& experiment);

}  // namespace opal::experiments
