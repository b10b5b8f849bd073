#pragma once

#include "benchmark/experiments/buildings/building_runs.hpp"
#include "benchmark/experiments/buildings/building_share.hpp"

#include <span>
#include <string>
#include <vector>

namespace opal::experiments {

/// What one contender did in some of the buildings, e.g. in those of a kind.
struct BuildingGroup {
  std::string kind;  ///< empty: all kinds
  std::optional<double> difficulty;
  std::string contender;
  std::size_t buildings = 0, runs = 0;
  BuildingShare success;                                ///< the best hypothesis is right up to the end
  BuildingShare localized;                              ///< and was called localized, and no other
  BuildingShare wrong;                                  ///< a wrong pose was called localized
  BuildingShare unknown;                                ///< not right, and honest
  BuildingMedian localized_after_m, localized_after_s;  ///< until the first pose that was called localized
  double cpu_ms = 0;                                    ///< per update, median of the runs

  /// "hall, difficulty 0.75"; "all"
  std::string name() const;
};

/// For each contender: all, each kind, each difficulty, each kind at each difficulty.
std::vector<BuildingGroup> groups_of(std::span<const BuildingRuns> buildings);

}  // namespace opal::experiments
