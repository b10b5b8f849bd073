#include "simulation/walker.hpp"

#include <algorithm>

namespace opal::simulation {
namespace {

constexpr double kLegRadius_m = 0.06, kHalfHip_m = 0.11, kStride_m = 0.28, kPersonalSpace_m = 0.4;

}  // namespace

Walker::Walker(const Floor& floor, Random random)
    : random_(random), speed_mps_(random_.uniform(0.6, 1.4)), position_(floor.anywhere(random_)) {}

void Walker::choose_way(const Floor& floor) {
  way_.clear();
  pause_s_ = random_.chance(0.3) ? random_.uniform(1, 10) : 0;
  if (auto way = floor.way(position_, floor.anywhere(random_))) way_.assign(way->rbegin(), way->rend());
}

/// Along the way, and round its corners.
void Walker::step(double length_m) {
  stride_rad_ += length_m / kStride_m * std::numbers::pi / 2;
  while (length_m > 0 && !way_.empty()) {
    const Point to = way_.back() - position_;
    const double distance = to.norm(), part = std::min(distance, length_m);
    if (distance > 0) direction_ = to / distance;
    position_ += part * direction_;
    length_m -= part;
    if (distance <= part) way_.pop_back();
  }
}

double Walker::nearest_foot_m(const Point& p) const {
  const auto feet = legs();
  return std::min((feet[0].center - p).norm(), (feet[1].center - p).norm());
}

/// A way to elsewhere may begin at the centre of a cell that is nearer: what counts is where it is a step on.
bool Walker::turns_away_from(const Point& p) const {
  constexpr double kStep_m = 0.5;
  const auto after = std::find_if(way_.rbegin(), way_.rend(),
                                  [&](const Point& there) { return (there - position_).norm() > kStep_m; });
  return after != way_.rend() && (*after - p).norm() > (position_ - p).norm();
}

void Walker::walk(double duration_s, const Floor& floor, const Circle& robot) {
  if (pause_s_ > 0) {
    pause_s_ -= duration_s;
    return;
  }
  if (way_.empty()) return choose_way(floor);
  Walker next = *this;
  next.step(speed_mps_ * duration_s);
  const double space_m = next.nearest_foot_m(robot.center) - robot.radius_m;
  const double before_m = nearest_foot_m(robot.center) - robot.radius_m;
  const bool trapped = before_m < kLegRadius_m;  // by a robot that has been put there: out, whichever way
  const bool leaves = turns_away_from(robot.center) && space_m > kLegRadius_m;
  if (space_m < kPersonalSpace_m && space_m < before_m && !leaves && !trapped) return way_.clear();
  *this = std::move(next);
}

std::array<Circle, 2> Walker::legs() const {
  const Point swing = kStride_m * std::sin(stride_rad_) * direction_, hip = kHalfHip_m * left_of(direction_);
  return {Circle{position_ + hip + swing, kLegRadius_m}, Circle{position_ - hip - swing, kLegRadius_m}};
}

}  // namespace opal::simulation
