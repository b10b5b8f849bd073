#pragma once

#include "benchmark/experiments/buildings/building_runs.hpp"

#include <string>

namespace opal::experiments {

/// Small pictures for a page that holds many of them. Classes of what is in them are for the page's style
/// sheet: `floor`, `wall`, `way`, `claim`, `believed`, `start`, and the names of outcomes.

/// The building's outline, once per page, for the others to refer to.
std::string outline_symbol(const BuildingRuns& building);
/// All ways of a contender in the building, by outcome, those that went wrong on top.
std::string ways_picture(const BuildingRuns& building, const std::string& contender);
/// One run: the way in truth from its start on, wrong poses that were called localized, and what is believed at
/// the end.
std::string run_picture(const BuildingRuns& building, const ChallengeRun& run);

}  // namespace opal::experiments
