#include "navigation/actions.hpp"

#include <algorithm>

namespace opal::navigation {

void Disambiguate::halt() { drive_.reset(); }

bool Disambiguate::choose(Blackboard& blackboard) {
  const PoseEstimate& estimate = blackboard.estimate();
  std::vector<PossiblePlace> places{{estimate.T_map_base, estimate.probability}};
  for (const PoseEstimate::Alternative& alternative : estimate.alternatives)
    if (static_cast<int>(places.size()) < options_.most_places)
      places.push_back({alternative.T_map_base, alternative.probability});
  std::vector<Point> avoided;
  for (const Point& p : visited_odom_) avoided.push_back(blackboard.T_map_odom() * p);
  const auto viewpoint = best_viewpoint(blackboard.localization.map(), blackboard.localization.laser(),
                                        blackboard.floor, unmapped_surcharge(blackboard), places, avoided, options_);
  compared_.clear();
  for (const PoseEstimate::Alternative& alternative : estimate.alternatives) compared_.insert(alternative.hypothesis);
  compared_.insert(estimate.best);
  best_ = estimate.best;
  if (!viewpoint) {
    failed_at_s_ = blackboard.now_s();
    return false;
  }
  drive_.emplace(blackboard.T_map_odom().inverse(), viewpoint->path);
  return true;
}

bool Disambiguate::has_new_alternatives(const PoseEstimate& estimate) const {
  return std::any_of(
      estimate.alternatives.begin(), estimate.alternatives.end(),
      [&](const PoseEstimate::Alternative& alternative) { return !compared_.contains(alternative.hypothesis); });
}

/// A place is chosen again when the robot is there, when another hypothesis is best, when new ones come, and when no
/// way leads there.
NodeStatus Disambiguate::tick(Blackboard& blackboard) {
  constexpr double kArrived_m = 0.3, kAskAgain_s = 3;
  const PoseEstimate& estimate = blackboard.estimate();
  const bool just_failed = blackboard.now_s() - failed_at_s_ < kAskAgain_s;
  if (!estimate.has_pose || estimate.alternatives.empty() || just_failed) {
    halt();
    return NodeStatus::failure;
  }
  if (drive_ && (drive_->arrived(blackboard, kArrived_m) || blackboard.is_stuck())) {
    visited_odom_.push_back(drive_->path().back());
    halt();
    blackboard.forget_being_stuck();
    return NodeStatus::success;
  }
  if ((!drive_ || estimate.best != best_ || has_new_alternatives(estimate)) && !choose(blackboard)) {
    halt();
    return NodeStatus::failure;
  }
  drive_->drive(blackboard);
  return NodeStatus::running;
}

}  // namespace opal::navigation
