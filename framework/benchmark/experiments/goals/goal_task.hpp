#pragma once

#include <opal/common/geometry.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace opal::experiments {

/// One run with control over the robot: from a place that it is not told to a goal.
struct GoalTask {
  std::string id;                     ///< "A3": set of patterns and route
  std::vector<std::string> patterns;  ///< the only ones that start hypotheses, where a configuration names any
  int pattern_size = 2;               ///< features of each
  Pose2 start;                        ///< T_map_base; the robot begins at the nearest place where nothing stands
  Point goal = Point::Zero();         ///< frame `map`; likewise
};

/// The 12 runs of Hendrikx (2023), table 4.1, in maps/gemini.jsonld: six starts, one goal; A with binary
/// patterns of columns, B with collinear and L-shaped triples. The thesis shows its starts in a picture
/// (figure 4.9) and tells their order by the time they took; ours are 11 to 54 m from the goal, the last two
/// in the hallway.
std::vector<GoalTask> thesis4_tasks();

/// The seed of a task's world: what stands and walks about, noise.
std::uint64_t world_seed(const GoalTask& task, std::uint64_t seed);

}  // namespace opal::experiments
