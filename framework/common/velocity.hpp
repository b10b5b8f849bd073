#pragma once

#include <opal/common/geometry.hpp>

namespace opal {

/// How a robot moves: velocities in `base_link` [m/s, rad/s]. A differential drive has no y.
struct Velocity {
  Point linear_mps = Point::Zero();
  double turn_radps = 0;
};

/// The motion in `base_link` of a constant velocity over a time: an arc of a circle.
inline Pose2 moved(const Velocity& velocity, double duration_s) {
  const double turn = velocity.turn_radps * duration_s;
  const Point way = velocity.linear_mps * duration_s;
  if (std::abs(turn) < 1e-9) return {way, turn};
  const double s = std::sin(turn) / turn, c = (1 - std::cos(turn)) / turn;
  return {s * way.x() - c * way.y(), c * way.x() + s * way.y(), turn};
}

}  // namespace opal
