#include "behaviours/actions.hpp"

namespace opal::behaviours {

namespace {

/// Where the robot has been lately, every 1.5 m, as it drove; frame base_link.
std::vector<Pose2> been(const Situation& situation) {
  constexpr std::size_t kEvery = 5, kMost = 100;
  const std::vector<Point>& trail = situation.trail();
  const Pose2 T_base_odom = situation.T_odom_base().inverse();
  std::vector<Pose2> poses;
  for (std::size_t k = trail.size() > kMost ? trail.size() - kMost : 0; k + 1 < trail.size(); k += kEvery) {
    const Point way = trail[k + 1] - trail[k];
    poses.push_back(T_base_odom * Pose2(trail[k], std::atan2(way.y(), way.x())));
  }
  return poses;
}

}  // namespace

void Disambiguate::halt() { drive_.reset(); }

bool Disambiguate::choose(Situation& situation) {
  const PoseEstimate& estimate = situation.estimate();
  std::vector<PossiblePlace> places{{estimate.T_map_base, estimate.probability}};
  for (const PoseEstimate::Rival& rival : estimate.rivals)
    if (static_cast<int>(places.size()) < options_.most_places) places.push_back({rival.T_map_base, rival.probability});
  std::vector<Point> avoided;
  for (const Point& p : visited_odom_) avoided.push_back(situation.T_map_odom() * p);
  const auto viewpoint = best_viewpoint(situation.localization.map(), situation.localization.laser(), situation.floor,
                                        unmapped_surcharge(situation), places, avoided, been(situation), options_);
  rivals_ = estimate.rivals.size();
  if (!viewpoint) {
    failed_at_s_ = situation.now_s();
    return false;
  }
  drive_.emplace(situation.T_map_odom().inverse(), viewpoint->path);
  return true;
}

/// A place is chosen again when the robot is there, when hypotheses come or go, and when no way leads there.
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
  if ((!drive_ || estimate.rivals.size() != rivals_) && !choose(situation)) {
    halt();
    return Outcome::failure;
  }
  drive_->drive(situation);
  return Outcome::running;
}

}  // namespace opal::behaviours
