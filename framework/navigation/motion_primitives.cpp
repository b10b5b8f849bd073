#include "navigation/motion_primitives.hpp"

#include "navigation/path.hpp"

#include <algorithm>
#include <limits>

namespace opal::navigation {
namespace {

MotionPrimitive predicted(const Velocity& velocity, const MotionOptions& options) {
  MotionPrimitive primitive{velocity, {}};
  for (double t = options.step_s; t < options.horizon_s + 1e-9; t += options.step_s)
    primitive.footprints.push_back(moved(velocity, t));
  return primitive;
}

std::vector<Point> linear_velocities(const MotionOptions& options) {
  std::vector<Point> linear;
  for (const double share : {0.0, 0.15, 0.3, 0.6, 1.0}) linear.emplace_back(share * options.speed_mps, 0);
  if (!options.omnidirectional) return linear;
  for (const double share : {0.3, 0.6, 1.0})
    for (const double bearing : {0.25, 0.5, 0.75})
      for (const int side : {-1, 1})
        linear.push_back(share * options.speed_mps * unit_vector(side * bearing * std::numbers::pi));
  return linear;
}

constexpr double kBerth_m = 0.4;  ///< the widest
constexpr double kBerth_s = 0.5;  ///< what moves is elsewhere later

double distance_to(const Point& p, std::span<const Obstacle> obstacles, double most_m) {
  double least = most_m * most_m;
  for (const Obstacle& obstacle : obstacles) least = std::min(least, (obstacle.position - p).squaredNorm());
  return std::sqrt(least);
}

}  // namespace

MotionPrimitives::MotionPrimitives(const MotionOptions& options) : options_(options) {
  for (const Point& linear : linear_velocities(options))
    for (const double share : {0.0, -0.2, 0.2, -0.4, 0.4, -0.7, 0.7, -1.0, 1.0})
      primitives_.push_back(predicted({linear, share * options.turn_radps}, options));
}

double MotionPrimitives::reach_m() const {
  return options_.speed_mps * options_.horizon_s + options_.radius_m + options_.margin_m + kBerth_m;
}

bool MotionPrimitives::is_free(const MotionPrimitive& primitive, std::span<const Obstacle> obstacles) const {
  for (const Obstacle& obstacle : obstacles) {
    const double keep = options_.radius_m + options_.margin_m, now = obstacle.position.norm() - 1e-6;
    const double soon = std::min(keep + obstacle.berth_m, now), later = std::min(keep, now);
    for (std::size_t k = 0; k < primitive.footprints.size(); ++k) {
      const double least = static_cast<double>(k) * options_.step_s < kBerth_s ? soon : later;
      if ((obstacle.position - primitive.footprints[k].position()).squaredNorm() < least * least) return false;
    }
  }
  return true;
}

/// What it costs to look away from a target, beyond what is left of the way.
double MotionPrimitives::misdirection_m(const Pose2& end, const Point& target) const {
  constexpr double kHeading_m_per_rad = 0.3, kThere_m = 0.2;
  const Point ahead = end.inverse() * target;
  if (ahead.norm() <= kThere_m) return 0;
  return (options_.omnidirectional ? 0.3 : 1) * kHeading_m_per_rad * std::abs(std::atan2(ahead.y(), ahead.x()));
}

/// The one after which least is left to do; to come near to something, and to change one's mind, costs a little.
std::optional<Velocity> MotionPrimitives::cheapest(const Left& left_m, std::span<const Obstacle> obstacles,
                                                   const Velocity& before) const {
  constexpr double kClearance_m = 0.25, kWanted_m = 0.35, kChange_s = 0.03;
  const MotionPrimitive* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const MotionPrimitive& primitive : primitives_) {
    const Point& halfway = primitive.footprints[primitive.footprints.size() / 2].position();
    const double clearance = distance_to(halfway, obstacles, kWanted_m + options_.radius_m) - options_.radius_m;
    const double price = left_m(primitive) + kClearance_m * (1 - clearance / kWanted_m) +
                         kChange_s * std::abs(primitive.velocity.turn_radps - before.turn_radps);
    if (price >= least || !is_free(primitive, obstacles)) continue;
    least = price;
    best = &primitive;
  }
  if (!best || (best->velocity.linear_mps.isZero() && best->velocity.turn_radps == 0)) return std::nullopt;
  return best->velocity;
}

std::optional<Velocity> MotionPrimitives::towards(const Point& target, std::span<const Obstacle> obstacles,
                                                  const Velocity& before) const {
  const auto left_m = [&](const MotionPrimitive& primitive) {
    const Pose2& end = primitive.footprints.back();
    return (target - end.position()).norm() + misdirection_m(end, target);
  };
  return cheapest(left_m, obstacles, before);
}

std::optional<Velocity> MotionPrimitives::along(std::span<const Point> path, std::span<const Obstacle> obstacles,
                                                const Velocity& before) const {
  constexpr double kEndOff = 1, kHalfwayOff = 0.5, kAhead_m = 0.5;
  const double whole_m = std::min(length_m(path), along_m());
  const auto left_m = [&](const MotionPrimitive& primitive) {
    const Pose2& end = primitive.footprints.back();
    const PlaceOnPath there = nearest_on_path(path, end.position(), 0, along_m());
    const PlaceOnPath halfway =
        nearest_on_path(path, primitive.footprints[primitive.footprints.size() / 2].position(), 0, along_m());
    return whole_m - std::min(there.along_m, whole_m) + kEndOff * there.off_m + kHalfwayOff * halfway.off_m +
           misdirection_m(end, point_along(path, there.along_m + kAhead_m));
  };
  return cheapest(left_m, obstacles, before);
}

double MotionPrimitives::room_m(double bearing_rad, std::span<const Point> obstacles, double most_m) const {
  const double keep = options_.radius_m + options_.margin_m;
  const Point direction = unit_vector(bearing_rad);
  double room = most_m;
  for (const Point& point : obstacles) {
    const double along = direction.dot(point), across = std::abs(cross(direction, point));
    if (along > 0 && across < keep) room = std::min(room, along - std::sqrt(keep * keep - across * across));
  }
  return std::max(0.0, room);
}

}  // namespace opal::navigation
