#include "navigation/actions.hpp"

#include "navigation/path.hpp"

#include <algorithm>
#include <limits>

namespace opal::navigation {

NodeStatus Rotate::tick(Blackboard& blackboard) {
  const Pose2 now = blackboard.T_odom_base();
  if (!before_)
    turned_rad_ = 0;
  else
    turned_rad_ += wrap_angle(now.heading_rad() - before_->heading_rad());
  before_ = now;
  if (std::abs(turned_rad_) >= 2 * std::numbers::pi * std::abs(turns_)) {
    before_.reset();
    return NodeStatus::success;
  }
  blackboard.turn(turns_ < 0 ? -turn_radps_ : turn_radps_);
  return NodeStatus::running;
}

NodeStatus BackOff::tick(Blackboard& blackboard) {
  constexpr double kArrived_m = 0.15, kLongest_s = 8;
  if (!target_odom_) {
    target_odom_ = blackboard.T_odom_base() * Point(-distance_m_, 0);
    began_s_ = blackboard.now_s();
  }
  const bool there = (*target_odom_ - blackboard.T_odom_base().position()).norm() < kArrived_m;
  if (!there && blackboard.now_s() - began_s_ < kLongest_s && blackboard.drive_towards(*target_odom_))
    return NodeStatus::running;
  halt();
  blackboard.forget_being_stuck();
  return NodeStatus::success;
}

void DriveFreely::halt() {
  target_odom_.reset();
  before_.reset();
}

namespace {

/// How probable it is, by what the hypotheses say, that a place is not on the building's floor.
double probability_off_floor(const Blackboard& blackboard, const Point& p_odom) {
  const PoseEstimate& estimate = blackboard.estimate();
  if (!estimate.has_pose) return 0;
  const Point p_base = blackboard.T_odom_base().inverse() * p_odom;
  const auto is_off = [&](const Pose2& T_map_base) {
    const auto place = blackboard.floor.nearest(T_map_base * p_base);
    return !place || blackboard.floor.is_outside(*place);
  };
  double sum = is_off(estimate.T_map_base) ? estimate.probability : 0;
  for (const PoseEstimate::Alternative& alternative : estimate.alternatives)
    if (is_off(alternative.T_map_base)) sum += alternative.probability;
  return sum;
}

constexpr double kOpen = 0.7, kEnclosed = 0.8;  ///< shares of beams that meet something

/// On the way back along the trail to the newest place that was enclosed, a little way ahead.
std::optional<Point> way_back_in(const Blackboard& blackboard) {
  constexpr double kAhead_m = 2, kElsewhere_m = 0.4;
  const auto& trail = blackboard.trail();
  const auto enclosed = std::find_if(trail.rbegin(), trail.rend(),
                                     [](const Blackboard::Been& been) { return been.met_share >= kEnclosed; });
  if (enclosed == trail.rend()) return std::nullopt;
  const Point here = blackboard.T_odom_base().position();
  const auto ahead = std::find_if(enclosed.base() - 1, trail.end(), [&](const Blackboard::Been& been) {
    const double left_m = (been.p_odom - here).norm();
    return left_m > kElsewhere_m && left_m < kAhead_m;
  });
  return ahead == trail.end() ? enclosed->p_odom : ahead->p_odom;
}

}  // namespace

Point DriveFreely::choose(const Blackboard& blackboard) const {
  constexpr int kDirections = 36;
  constexpr double kMost_m = 6, kVisited_m = 1.2, kSomething_m = 4;
  if (blackboard.met_share() < kOpen)
    if (const auto back = way_back_in(blackboard)) return *back;
  const Pose2& T_odom_base = blackboard.T_odom_base();
  const std::vector<Point> around = blackboard.around(kMost_m + 1);
  Point best = T_odom_base.position();
  double most = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < kDirections; ++k) {
    const double bearing = wrap_angle(2 * std::numbers::pi * k / kDirections);
    const double room = blackboard.motion.room_m(bearing, around, kMost_m);
    const Point target = T_odom_base * Point(0.8 * room * unit_vector(bearing));
    double score = room * (1 + 0.5 * std::cos(bearing));
    for (const Blackboard::Been& been : blackboard.trail())
      if ((been.p_odom - target).norm() < kVisited_m) score -= 0.3;
    const auto near = [&](const Point& p) { return (T_odom_base * p - target).norm() < kSomething_m; };
    if (std::none_of(around.begin(), around.end(), near)) score -= kMost_m;  // where nothing is, nothing is learnt
    score -= kMost_m * probability_off_floor(blackboard, target);
    if (score <= most) continue;
    most = score;
    best = target;
  }
  return best;
}

NodeStatus DriveFreely::tick(Blackboard& blackboard) {
  constexpr double kArrived_m = 0.4, kLongest_s = 15, kPatience_s = 10;
  const Pose2 now = blackboard.T_odom_base();
  if (!before_) {
    driven_m_ = 0;
    could_move_at_s_ = blackboard.now_s();
  } else {
    driven_m_ += opal::distance_m(*before_, now);
  }
  before_ = now;
  const bool enclosed = blackboard.now_s() - could_move_at_s_ > kPatience_s;
  if (enclosed || (distance_m_ > 0 && driven_m_ >= distance_m_)) {
    halt();
    return enclosed ? NodeStatus::failure : NodeStatus::success;
  }
  const bool stale = blackboard.now_s() - chosen_at_s_ > kLongest_s;
  const bool open = blackboard.met_share() < kOpen;
  if (open && !was_open_) target_odom_.reset();
  was_open_ = open;
  if (!target_odom_ || stale || (*target_odom_ - now.position()).norm() < kArrived_m) {
    target_odom_ = choose(blackboard);
    chosen_at_s_ = blackboard.now_s();
  }
  if (blackboard.drive_towards(*target_odom_))
    could_move_at_s_ = blackboard.now_s();
  else
    target_odom_.reset();
  return NodeStatus::running;
}

NodeStatus KeepPattern::tick(Blackboard& blackboard) {
  if (blackboard.localization.pattern().empty()) return NodeStatus::failure;
  blackboard.keep_pattern();
  return NodeStatus::success;
}

NodeStatus DriveBetweenFeatures::tick(Blackboard& blackboard) {
  constexpr double kArrived_m = 0.3, kLongest_s = 40, kFarthest_m = 15;
  if (!target_odom_) {
    const std::vector<Geometry> pattern = blackboard.localization.pattern();
    if (pattern.size() < 2) return NodeStatus::failure;
    const Point between = 0.5 * (anchor_of(pattern[0]) + anchor_of(pattern[1]));
    if (between.norm() > kFarthest_m) return NodeStatus::failure;
    target_odom_ = blackboard.T_odom_base() * between;
    began_s_ = blackboard.now_s();
  }
  const double left_m = (*target_odom_ - blackboard.T_odom_base().position()).norm();
  if (left_m < kArrived_m || blackboard.is_stuck() || blackboard.now_s() - began_s_ > kLongest_s) {
    target_odom_.reset();
    return left_m < kArrived_m ? NodeStatus::success : NodeStatus::failure;
  }
  blackboard.drive_towards(*target_odom_);
  return NodeStatus::running;
}

namespace {

/// Where a way first becomes dear, from a little way ahead on; there if it does nowhere near. Frame `map`.
Point first_narrow(const Blackboard& blackboard, std::span<const Point> way, const FloorGrid::Surcharge& prices) {
  constexpr double kNear_m = 4;
  const double ahead_m = blackboard.motion.options().radius_m + blackboard.motion.options().margin_m;
  for (double along_m = ahead_m; along_m < std::min(kNear_m, length_m(way)); along_m += blackboard.floor.cell_m()) {
    const Point p = point_along(way, along_m);
    const int cell = blackboard.floor.cell_at(p);
    if (cell >= 0 && prices[static_cast<std::size_t>(cell)] > 0) return p;
  }
  return point_along(way, ahead_m);
}

}  // namespace

/// Whoever comes and goes before something is about the same place again and again, with other nodes in between.
void GoToGoal::notice_lingering(const Blackboard& blackboard) {
  constexpr double kAbout_m = 3, kInterrupted_s = 1;
  const Point& here = blackboard.T_odom_base().position();
  const double since_s = blackboard.now_s() - ticked_at_s_;
  ticked_at_s_ = blackboard.now_s();
  if (since_s < kInterrupted_s) lingering_s_ += since_s;
  if ((here - lingering_from_odom_).norm() < kAbout_m) return;
  lingering_from_odom_ = here;
  lingering_s_ = 0;
}

bool GoToGoal::plan(Blackboard& blackboard) {
  constexpr double kPatience_s = 30;
  FloorGrid::Surcharge prices;
  std::optional<std::vector<Point>> way;
  const auto look_for_way = [&] {
    prices = unmapped_surcharge(blackboard);
    way = blackboard.floor.way(blackboard.estimate().T_map_base.position(), blackboard.goal, prices);
  };
  look_for_way();
  if (way && lingering_s_ > kPatience_s) {
    lingering_s_ = 0;
    blackboard.give_up(first_narrow(blackboard, *way, prices));
    look_for_way();
  }
  if (way && blackboard.try_again(*way)) look_for_way();
  if (!way) return false;
  drive_.emplace(blackboard.T_map_odom().inverse(), blackboard.floor.straightened(*way, prices));
  planned_at_s_ = blackboard.now_s();
  return true;
}

NodeStatus GoToGoal::tick(Blackboard& blackboard) {
  constexpr double kReplan_s = 1;
  if (!blackboard.estimate().has_pose) return NodeStatus::failure;
  if ((blackboard.estimate().T_map_base.position() - blackboard.goal).norm() < arrived_m_) return NodeStatus::success;
  notice_lingering(blackboard);
  const bool stale = !drive_ || blackboard.now_s() - planned_at_s_ > kReplan_s;
  if (stale && !plan(blackboard)) return NodeStatus::failure;
  drive_->drive(blackboard);
  return NodeStatus::running;
}

}  // namespace opal::navigation
