#include "navigation/actions.hpp"

#include <algorithm>
#include <limits>

namespace opal::behaviours {

Outcome Rotate::tick(Situation& situation) {
  const Pose2 now = situation.T_odom_base();
  if (!before_) turned_rad_ = 0;
  else turned_rad_ += wrap_angle(now.heading_rad() - before_->heading_rad());
  before_ = now;
  if (std::abs(turned_rad_) >= 2 * std::numbers::pi * std::abs(turns_)) {
    before_.reset();
    return Outcome::success;
  }
  situation.turn(turns_ < 0 ? -turn_radps_ : turn_radps_);
  return Outcome::running;
}

Outcome BackOff::tick(Situation& situation) {
  constexpr double kArrived_m = 0.15, kLongest_s = 8;
  if (!target_odom_) {
    target_odom_ = situation.T_odom_base() * Point(-distance_m_, 0);
    began_s_ = situation.now_s();
  }
  const bool there = (*target_odom_ - situation.T_odom_base().position()).norm() < kArrived_m;
  if (!there && situation.now_s() - began_s_ < kLongest_s && situation.drive_towards(*target_odom_)) return Outcome::running;
  halt();
  situation.forget_being_stuck();
  return Outcome::success;
}

void DriveFreely::halt() {
  target_odom_.reset();
  before_.reset();
}

namespace {

/// How probable it is, by what the hypotheses say, that a place is not on the building's floor.
double probability_off_floor(const Situation& situation, const Point& p_odom) {
  const PoseEstimate& estimate = situation.estimate();
  if (!estimate.has_pose) return 0;
  const Point p_base = situation.T_odom_base().inverse() * p_odom;
  const auto is_off = [&](const Pose2& T_map_base) {
    const auto place = situation.floor.nearest(T_map_base * p_base);
    return !place || situation.floor.is_outside(*place);
  };
  double sum = is_off(estimate.T_map_base) ? estimate.probability : 0;
  for (const PoseEstimate::Rival& rival : estimate.rivals)
    if (is_off(rival.T_map_base)) sum += rival.probability;
  return sum;
}

constexpr double kOpen = 0.7, kEnclosed = 0.8;  ///< shares of beams that meet something

/// On the way back along the trail to the newest place that was enclosed, a little way ahead.
std::optional<Point> way_back_in(const Situation& situation) {
  constexpr double kAhead_m = 2, kElsewhere_m = 0.4;
  const auto& trail = situation.trail();
  const auto enclosed = std::find_if(trail.rbegin(), trail.rend(), [](const Situation::Been& been) { return been.met_share >= kEnclosed; });
  if (enclosed == trail.rend()) return std::nullopt;
  const Point here = situation.T_odom_base().position();
  const auto ahead = std::find_if(enclosed.base() - 1, trail.end(), [&](const Situation::Been& been) {
    const double left_m = (been.p_odom - here).norm();
    return left_m > kElsewhere_m && left_m < kAhead_m;
  });
  return ahead == trail.end() ? enclosed->p_odom : ahead->p_odom;
}

}  // namespace

Point DriveFreely::choose(const Situation& situation) const {
  constexpr int kDirections = 36;
  constexpr double kMost_m = 6, kVisited_m = 1.2, kSomething_m = 4;
  if (situation.met_share() < kOpen)
    if (const auto back = way_back_in(situation)) return *back;
  const Pose2& T_odom_base = situation.T_odom_base();
  const std::vector<Point> around = situation.around(kMost_m + 1);
  Point best = T_odom_base.position();
  double most = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < kDirections; ++k) {
    const double bearing = wrap_angle(2 * std::numbers::pi * k / kDirections);
    const double room = situation.motion.room_m(bearing, around, kMost_m);
    const Point target = T_odom_base * Point(0.8 * room * unit_vector(bearing));
    double score = room * (1 + 0.5 * std::cos(bearing));
    for (const Situation::Been& been : situation.trail())
      if ((been.p_odom - target).norm() < kVisited_m) score -= 0.3;
    const auto near = [&](const Point& p) { return (T_odom_base * p - target).norm() < kSomething_m; };
    if (std::none_of(around.begin(), around.end(), near)) score -= kMost_m;  // where nothing is, nothing is learnt
    score -= kMost_m * probability_off_floor(situation, target);
    if (score <= most) continue;
    most = score;
    best = target;
  }
  return best;
}

Outcome DriveFreely::tick(Situation& situation) {
  constexpr double kArrived_m = 0.4, kLongest_s = 15;
  const Pose2 now = situation.T_odom_base();
  if (!before_) driven_m_ = 0;
  else driven_m_ += opal::distance_m(*before_, now);
  before_ = now;
  if (distance_m_ > 0 && driven_m_ >= distance_m_) {
    halt();
    return Outcome::success;
  }
  const bool stale = situation.now_s() - chosen_at_s_ > kLongest_s;
  const bool open = situation.met_share() < kOpen;
  if (open && !was_open_) target_odom_.reset();
  was_open_ = open;
  if (!target_odom_ || stale || (*target_odom_ - now.position()).norm() < kArrived_m) {
    target_odom_ = choose(situation);
    chosen_at_s_ = situation.now_s();
  }
  if (!situation.drive_towards(*target_odom_)) target_odom_.reset();
  return Outcome::running;
}

Outcome KeepPattern::tick(Situation& situation) {
  if (situation.localization.pattern().empty()) return Outcome::failure;
  situation.keep_pattern();
  return Outcome::success;
}

Outcome DriveBetweenFeatures::tick(Situation& situation) {
  constexpr double kArrived_m = 0.3, kLongest_s = 40, kFarthest_m = 15;
  if (!target_odom_) {
    const std::vector<Geometry> pattern = situation.localization.pattern();
    if (pattern.size() < 2) return Outcome::failure;
    const Point between = 0.5 * (anchor_of(pattern[0]) + anchor_of(pattern[1]));
    if (between.norm() > kFarthest_m) return Outcome::failure;
    target_odom_ = situation.T_odom_base() * between;
    began_s_ = situation.now_s();
  }
  const double left_m = (*target_odom_ - situation.T_odom_base().position()).norm();
  if (left_m < kArrived_m || situation.is_stuck() || situation.now_s() - began_s_ > kLongest_s) {
    target_odom_.reset();
    return left_m < kArrived_m ? Outcome::success : Outcome::failure;
  }
  situation.drive_towards(*target_odom_);
  return Outcome::running;
}

Outcome GoToGoal::tick(Situation& situation) {
  constexpr double kReplan_s = 1;
  if (!situation.estimate().has_pose) return Outcome::failure;
  if ((situation.estimate().T_map_base.position() - situation.goal).norm() < arrived_m_) return Outcome::success;
  if (!drive_ || situation.now_s() - planned_at_s_ > kReplan_s) {
    const FloorGrid::Surcharge prices = unmapped_surcharge(situation);
    const auto way = situation.floor.way(situation.estimate().T_map_base.position(), situation.goal, prices);
    if (!way) return Outcome::failure;
    drive_.emplace(situation.T_map_odom().inverse(), situation.floor.straightened(*way, prices));
    planned_at_s_ = situation.now_s();
  }
  drive_->drive(situation);
  return Outcome::running;
}

}  // namespace opal::behaviours
