#include "navigation/actions.hpp"

#include <algorithm>

namespace opal::behaviours {

void Disambiguate::halt() { drive_.reset(); }

bool Disambiguate::choose(Situation& situation) {
  const PoseEstimate& estimate = situation.estimate();
  std::vector<PossiblePlace> places{{estimate.T_map_base, estimate.probability}};
  for (const PoseEstimate::Rival& rival : estimate.rivals)
    if (static_cast<int>(places.size()) < options_.most_places) places.push_back({rival.T_map_base, rival.probability});
  std::vector<Point> avoided;
  for (const Point& p : visited_odom_) avoided.push_back(situation.T_map_odom() * p);
  const auto viewpoint = best_viewpoint(situation.localization.map(), situation.localization.laser(), situation.floor,
                                        unmapped_surcharge(situation), places, avoided, options_);
  compared_.clear();
  for (const PoseEstimate::Rival& rival : estimate.rivals) compared_.insert(rival.hypothesis);
  compared_.insert(estimate.best);
  best_ = estimate.best;
  if (!viewpoint) {
    failed_at_s_ = situation.now_s();
    return false;
  }
  drive_.emplace(situation.T_map_odom().inverse(), viewpoint->path);
  return true;
}

bool Disambiguate::has_new_rivals(const PoseEstimate& estimate) const {
  return std::any_of(estimate.rivals.begin(), estimate.rivals.end(),
                     [&](const PoseEstimate::Rival& rival) { return !compared_.contains(rival.hypothesis); });
}

/// A place is chosen again when the robot is there, when another hypothesis is best, when new ones come, and when no way leads
/// there.
Outcome Disambiguate::tick(Situation& situation) {
  constexpr double kArrived_m = 0.3, kAskAgain_s = 3;
  const PoseEstimate& estimate = situation.estimate();
  const bool just_failed = situation.now_s() - failed_at_s_ < kAskAgain_s;
  if (!estimate.has_pose || estimate.rivals.empty() || just_failed) {
    halt();
    return Outcome::failure;
  }
  if (drive_ && (drive_->arrived(situation, kArrived_m) || situation.is_stuck())) {
    visited_odom_.push_back(drive_->path().back());
    halt();
    situation.forget_being_stuck();
    return Outcome::success;
  }
  if ((!drive_ || estimate.best != best_ || has_new_rivals(estimate)) && !choose(situation)) {
    halt();
    return Outcome::failure;
  }
  drive_->drive(situation);
  return Outcome::running;
}

}  // namespace opal::behaviours
