#include "simulation/walker.hpp"

namespace opal::simulation {
namespace {

constexpr double kLegRadius_m = 0.06, kHalfHip_m = 0.11, kStride_m = 0.28, kPersonalSpace_m = 0.8;

}  // namespace

Walker::Walker(const Floor& floor, Random random)
    : random_(random), speed_mps_(random_.uniform(0.6, 1.4)), position_(floor.anywhere(random_)) {}

void Walker::choose_way(const Floor& floor) {
  way_.clear();
  pause_s_ = random_.chance(0.3) ? random_.uniform(1, 10) : 0;
  if (auto way = floor.way(position_, floor.anywhere(random_))) way_.assign(way->rbegin(), way->rend());
}

void Walker::walk(double duration_s, const Floor& floor, const Point& robot) {
  if (pause_s_ > 0) {
    pause_s_ -= duration_s;
    return;
  }
  if (way_.empty()) return choose_way(floor);
  double left_m = speed_mps_ * duration_s;
  stride_rad_ += left_m / kStride_m * std::numbers::pi / 2;
  while (left_m > 0 && !way_.empty()) {
    const Point to = way_.back() - position_;
    const double distance = to.norm(), step = std::min(distance, left_m);
    const Point next = distance > 0 ? Point(position_ + step / distance * to) : position_;
    const bool nearer = (next - robot).norm() < (position_ - robot).norm();
    if (nearer && (next - robot).norm() < kPersonalSpace_m) return way_.clear();
    if (distance > 0) direction_ = to / distance;
    position_ = next;
    left_m -= step;
    if (distance <= step) way_.pop_back();
    if (step == 0 && distance > 0) break;
  }
}

std::array<Circle, 2> Walker::legs() const {
  const Point swing = kStride_m * std::sin(stride_rad_) * direction_, hip = kHalfHip_m * left_of(direction_);
  return {Circle{position_ + hip + swing, kLegRadius_m}, Circle{position_ - hip - swing, kLegRadius_m}};
}

}  // namespace opal::simulation
