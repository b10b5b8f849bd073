#pragma once

#include "benchmark/experiments/buildings/buildings_report.hpp"

namespace opal::experiments {

/// One HTML file that needs no other: groups, every run that failed with a picture, and all buildings.
std::string buildings_page(const BuildingsExperiment& experiment);

}  // namespace opal::experiments
