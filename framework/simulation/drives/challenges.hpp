#pragma once

#include "simulation/drives/recording.hpp"

#include <opal/localization/options/localizer_options.hpp>

#include <optional>
#include <string>
#include <vector>

namespace opal::simulation {

/// One localization task without control over the robot: a start, a way, and what stands there.
struct Challenge {
  std::string id;
  int route = 0;  ///< which start and goals: the same number is the same way, whatever stands there
  ClutterOptions clutter;
  int people = 0;
  std::optional<double> region_m;  ///< radius of a region around the start that the robot is told; nullopt: nothing
};

/// The 14 challenges of Hendrikx (2023), 3.5.2: A, two starts within a known region, everyday clutter; B, ten starts,
/// the whole map, people and clutter; C, two starts with features hidden and mimicked on purpose.
std::vector<Challenge> thesis3_challenges();

/// One minute of driving as somebody steers the robot from the challenge's start.
struct ChallengeDrive {
  Recording recording;
  std::optional<RegionPrior> region;  ///< around the start, that the robot is told
};

/// @param seed  of noise, clutter and people; start and goals do not depend on it.
ChallengeDrive drive(const Challenge& challenge, std::shared_ptr<const SemanticMap> building, SimulationOptions options,
                     double duration_s, std::uint64_t seed);

}  // namespace opal::simulation
