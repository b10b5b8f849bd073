#pragma once

#include "navigation/blackboard.hpp"

#include <optional>
#include <span>

namespace opal::navigation {

struct DisambiguateOptions {
  double view_m = 12;              ///< expected scans reach so far
  int most_places = 6;             ///< hypotheses that are compared: the most probable ones
  double least_separation = 0.05;  ///< in [0, 1]; places expected to tell less are not gone to
};

/// A place where the robot may be.
struct PossiblePlace {
  Pose2 T_map_base;
  double probability = 0;
};

/// The ranges that a laser would read at a pose in the building as mapped, at most view_m, in `beams` directions of its
/// field of view.
std::vector<double> expected_ranges(const MapView& map, const LaserModel& laser, const Pose2& T_map_base, double view_m,
                                    int beams = 60);

/// How well two expected scans can be told apart, in [0, 1]: 1 where a tenth of the beams differ clearly.
double separation(std::span<const double> a, std::span<const double> b);

/// A place to go to, and how.
struct Viewpoint {
  std::vector<Point> path;  ///< frame `map`, by the best hypothesis
  double separation = 0;    ///< expected there beyond what is seen from here, over pairs of hypotheses, in [0, 1]
};

/// The place that tells hypotheses apart at the least expense of driving: for each of them, what would be seen from
/// there if it was right is computed from the map, and compared.
/// @param places   most probable first; the first is the one by which the way is planned.
/// @param avoided  where it has been tried, frame `map` by the first place.
/// @return nullopt if no place is expected to help.
std::optional<Viewpoint> best_viewpoint(const MapView& map, const LaserModel& laser, const FloorGrid& floor,
                                        const FloorGrid::Surcharge& surcharge, std::span<const PossiblePlace> places,
                                        std::span<const Point> avoided, const DisambiguateOptions& options = {});

}  // namespace opal::navigation
