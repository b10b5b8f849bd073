#include "navigation/blackboard.hpp"

#include "navigation/path.hpp"

#include <opal/common/error.hpp>
#include "map_tools/building_ground.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal::navigation {

FloorGrid mapped_floor(const MapView& map, double radius_m, bool outdoors) {
  const BuildingGround ground(map.map(), outdoors);
  FloorGrid floor = ground.floor_with_outside([&](const Point& p) { return map.clearance_m(p) > radius_m; });
  if (floor.cells().empty())
    throw MapError(fmt::format("{}: has no floor for a robot of {:f} m radius", map.map().name(), radius_m));
  return floor;
}

namespace {

FloorGrid::Surcharge price_of_tight_floor(const FloorGrid& floor, const MapView& map, double needed_m) {
  constexpr float kTight = 25;  // as beside what is not mapped
  FloorGrid::Surcharge prices = floor.no_surcharge();
  for (const int cell : floor.cells())
    if (map.clearance_m(floor.center_of(cell)) < needed_m) prices[static_cast<std::size_t>(cell)] = kTight;
  return prices;
}

template <class Places>
std::vector<Point> places_of(const Places& all) {
  std::vector<Point> points;
  for (const auto& each : all) points.push_back(each.p_map);
  return points;
}

}  // namespace

Blackboard::Blackboard(const LocalizationQueries& queries, const MotionPrimitives& primitives,
                       const FloorGrid& mapped_floor, const Point& wanted)
    : localization(queries),
      motion(primitives),
      floor(mapped_floor),
      goal(wanted),
      tight(price_of_tight_floor(mapped_floor, queries.map(),
                                 primitives.options().radius_m + primitives.options().margin_m)) {}

void Blackboard::look() {
  before_ = velocity_;
  estimate_ = localization.estimate();
  obstacles_.add(localization.newest_scan(), T_odom_base(), localization.laser().T_base_laser);
  near_ = obstacles_.near(motion.reach_m());
  if (estimate_.status == Status::localized) leave_out_mapped_berths();
  notice_progress();
  notice_unmapped();
  notice_passed();
  velocity_ = {};
  wants_pattern_alone_ = false;
}

/// What is mapped does not walk, though panes may seem to: they send back some beams of one scan and none of the next.
void Blackboard::leave_out_mapped_berths() {
  constexpr double kMapped_m = 0.15;
  for (Obstacle& obstacle : near_)
    if (obstacle.berth_m > 0 && localization.map().clearance_m(estimate_.T_map_base * obstacle.position) < kMapped_m)
      obstacle.berth_m = 0;
}

double Blackboard::met_share() const {
  const Scan& scan = localization.newest_scan();
  const std::size_t all = scan.points.size() + scan.free_bearings_rad.size();
  return all == 0 ? 0 : static_cast<double>(scan.points.size()) / static_cast<double>(all);
}

void Blackboard::notice_progress() {
  constexpr double kSpacing_m = 0.3, kProgress_m = 0.2;
  const Point& here = T_odom_base().position();
  if (trail_.empty() || (trail_.back().p_odom - here).norm() > kSpacing_m) trail_.push_back({here, met_share()});
  if (!wanted_odom_ || (here - moved_from_).norm() > kProgress_m) {
    moved_from_ = here;
    moved_at_s_ = now_s();
  }
  notice_impasse();
  wanted_odom_.reset();
}

/// Somebody in the way is no impasse: who comes also goes.
void Blackboard::notice_impasse() {
  constexpr double kSomebody_m = 0.8;
  if (!is_stuck() || !wanted_odom_ || !estimate_.has_pose) return;
  const Point here = T_odom_base().position(), way = *wanted_odom_ - here;
  if (way.isZero()) return;
  const double ahead_m = motion.options().radius_m + motion.options().margin_m;
  const Point p = here + std::min(ahead_m, way.norm()) * way.normalized();
  const auto is_there = [&](const Point& somebody) { return (somebody - p).norm() < kSomebody_m; };
  const std::vector<Point> people = obstacles_.moving(ahead_m + kSomebody_m);
  if (std::none_of(people.begin(), people.end(), is_there)) bar(T_map_odom() * p, Reason::stuck);
}

/// Where the robot was stuck not for long the first time: it may have been somebody who has gone on since.
void Blackboard::bar(const Point& p_map, Reason reason) {
  constexpr double kOnce_s = 60, kAgain_s = 600, kApart_m = 0.3;
  for (Impasse& impasse : impasses_) {
    if ((impasse.p_map - p_map).norm() > kApart_m) continue;
    if (reason == Reason::given_up || now_s() > impasse.until_s) impasse.until_s = now_s() + kAgain_s;
    return;
  }
  impasses_.push_back({p_map, now_s() + (reason == Reason::given_up ? kAgain_s : kOnce_s)});
}

bool Blackboard::try_again(std::span<const Point> way_map) {
  constexpr double kCloser_m = 0.05;  // a robot that turns back begins beside what it turns back from
  const double keep_m = motion.options().radius_m + motion.options().margin_m;
  const auto is_on_way = [&](const Impasse& impasse) {
    const double off_m = nearest_on_path(way_map, impasse.p_map).off_m;
    const bool leads_there = off_m < (way_map.front() - impasse.p_map).norm() - kCloser_m;
    return now_s() < impasse.until_s && off_m < keep_m && leads_there;
  };
  bool any = false;
  for (Impasse& impasse : impasses_) {
    if (!is_on_way(impasse)) continue;
    impasse.until_s = now_s();
    any = true;
  }
  return any;
}

void Blackboard::notice_unmapped() {
  constexpr double kEvery_s = 0.5, kReach_m = 10, kMapped_m = 0.25, kKept_s = 300, kSamePlace_m = 0.5;
  if (!estimate_.has_pose || now_s() - noticed_at_s_ < kEvery_s) return;
  noticed_at_s_ = now_s();
  const Point here = estimate_.T_map_base.position();
  const bool elsewhere = (T_map_odom_noticed_ * T_odom_base().position() - here).norm() > kSamePlace_m;
  if (elsewhere) unmapped_.clear(), passed_.clear(), impasses_.clear();  // another hypothesis is best
  T_map_odom_noticed_ = T_map_odom();
  std::erase_if(unmapped_, [&](const Stamped& seen) {
    return (seen.p_map - here).norm() <= kReach_m || now_s() - seen.stamp_s > kKept_s;
  });
  for (const Point& p_odom : obstacles_.standing(kReach_m)) {
    const Point p = T_map_odom_noticed_ * p_odom;
    if (localization.map().clearance_m(p) > kMapped_m) unmapped_.push_back({p, now_s()});
  }
}

std::vector<Point> Blackboard::unmapped() const { return places_of(unmapped_); }

void Blackboard::notice_passed() {
  constexpr double kSpacing_m = 0.1, kKept_s = 300;
  while (!passed_.empty() && now_s() - passed_.front().stamp_s > kKept_s) passed_.pop_front();
  if (estimate_.status != Status::localized) return;
  const Point here = estimate_.T_map_base.position();
  if (passed_.empty() || (passed_.back().p_map - here).norm() > kSpacing_m) passed_.push_back({here, now_s()});
}

std::vector<Point> Blackboard::passed() const { return places_of(passed_); }

std::vector<Point> Blackboard::impasses() const {
  std::vector<Point> points;
  for (const Impasse& impasse : impasses_)
    if (now_s() < impasse.until_s) points.push_back(impasse.p_map);
  return points;
}

bool Blackboard::drive_towards(const Point& target_odom) {
  wanted_odom_ = target_odom;
  const auto velocity = motion.towards(T_odom_base().inverse() * target_odom, near_, before_);
  velocity_ = velocity.value_or(Velocity{});
  return velocity.has_value();
}

bool Blackboard::drive_along(const std::vector<Point>& path_odom) {
  wanted_odom_ = point_along(path_odom, motion.along_m());
  std::vector<Point> path;
  for (const Point& p : path_odom) path.push_back(T_odom_base().inverse() * p);
  const auto velocity = motion.along(path, near_, before_);
  velocity_ = velocity.value_or(Velocity{});
  return velocity.has_value();
}

std::vector<Point> Blackboard::around(double reach_m) const {
  std::vector<Point> points;
  for (const Obstacle& obstacle : obstacles_.near(reach_m)) points.push_back(obstacle.position);
  return points;
}

}  // namespace opal::navigation
