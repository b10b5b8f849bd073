#include "localization/alignment/pose_grid.hpp"
#include "localization/alignment/registration.hpp"
#include "localization/tree/hypothesis_set.hpp"

#include <cmath>

// How hypotheses are carried to the newest scan, and aligned with the map there.

namespace opal {
namespace {

// Hypotheses that get an alignment search when odometry is uncertain; the search costs as much as tracking fifty.
constexpr int kSearchedHypotheses = 15;
// Steps of that search: either moves a point at 3 m by a tenth of a metre, from which alignment recovers.
constexpr double kSearchStep_m = 0.1, kSearchStep_rad = 0.03;
// How much better a pose at the border of that search must fit than dead reckoning: of poses that fit alike, the
// nearest is the likeliest.
constexpr double kCostOfDistance = 0.02;

}  // namespace

Pose2 HypothesisSet::search_alignment(const Pose2& predicted, std::span<const Point> coarse,
                                      const Eigen::Vector2d& window) const {
  const PoseGrid grid = PoseGrid::covering(window.x(), window.y(), kSearchStep_m, kSearchStep_rad);
  Pose2 best = predicted;
  double best_value = -1;
  for_each_pose(predicted, grid, [&](const Pose2& pose, const GridSteps& at) {
    const double far =
        std::hypot(at.x, at.y) * grid.step_m / window.x() + std::abs(at.turn) * grid.step_rad / window.y();
    const double value = likelihood_field_score(*map_, coarse, pose) - kCostOfDistance * far;
    if (value > best_value) {
      best_value = value;
      best = pose;
    }
  });
  return best;
}

Alignment HypothesisSet::align(const Pose2& predicted, const Observation& observation) const {
  if (growth_.register_by_associations || observation.points() == 0) return {predicted};
  RefinementOptions refinement;
  refinement.prior_position = tracking_.prior_position;
  refinement.prior_heading = tracking_.prior_heading;
  return align_with_map(*map_, observation.scans, predicted, refinement);
}

auto HypothesisSet::align_all(const Observation& observation, std::span<const Point> coarse,
                              const Eigen::Vector2d& window) -> std::vector<Moved> {
  const Pose2& T_local_base = observation.local_map.T_local_base();
  std::vector<Moved> moved;
  int rank = 0;
  for (Live& live : alive_) {
    Pose2 predicted = live.hypothesis.T_map_local * T_local_base;
    if (observation.points() > 0 && window.x() > 0 && rank++ < kSearchedHypotheses) {
      predicted = search_alignment(predicted, coarse, window);
      live.pose.reset();  // dead reckoning has failed, and what was known goes with it
    }
    // The scan is judged where it fits best: a wall that is not where the map says is the map's error, not its own.
    moved.push_back({predicted, align(predicted, observation)});
    live.hypothesis.T_map_local = moved.back().scan.T_map_base * T_local_base.inverse();
  }
  return moved;
}

}  // namespace opal
