#pragma once

#include "common/velocity.hpp"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace opal::navigation {

/// A round robot and what it may do.
struct MotionOptions {
  bool omnidirectional = false;
  double radius_m = 0.3;
  double margin_m = 0.06;  ///< kept between the robot and what the laser sees
  double speed_mps = 0.7;
  double turn_radps = 1.0;
  double horizon_s = 1.5;  ///< over which a motion must be free
  double step_s = 0.125;   ///< between predicted footprints
};

/// One velocity, kept up over the horizon.
struct MotionPrimitive {
  Velocity velocity;
  std::vector<Pose2> footprints;  ///< centres of the robot to come, frame: base_link now
};

/// A point that the laser sees, frame base_link.
struct Obstacle {
  Point position = Point::Zero();
  double berth_m = 0;  ///< kept besides the margin for the next half second: for what moves; at most 0.4
};

/// A small set of velocities whose footprints are predicted and checked against what the laser sees (Hendrikx 2023,
/// 4.3.8; Fox, Burgard and Thrun 1997). None goes back, where few lasers look: a round robot turns on the spot instead.
/// All points: frame base_link [m].
class MotionPrimitives {
 public:
  explicit MotionPrimitives(const MotionOptions& options = {});

  const MotionOptions& options() const { return options_; }
  const std::vector<MotionPrimitive>& all() const { return primitives_; }
  /// Points farther away than this concern no primitive.
  double reach_m() const;

  /// Whether no footprint comes nearer to an obstacle than radius, margin and its berth. One that is nearer already
  /// does not keep the robot from going away from it, and none keeps it from turning on the spot.
  bool is_free(const MotionPrimitive& primitive, std::span<const Obstacle> obstacles) const;
  /// The free primitive that brings the robot nearest to a target and turns it there.
  /// @param before  velocity so far: changing one's mind costs a little.
  /// @return nullopt if none is better than to stand still.
  std::optional<Velocity> towards(const Point& target, std::span<const Obstacle> obstacles,
                                  const Velocity& before = {}) const;
  /// The free primitive that gets farthest along a path and stays on it; a way round a corner is as good as a straight
  /// one.
  /// @param path  straight pieces, from where the robot is on it; not empty. What is farther than `along_m()` does not
  /// matter.
  std::optional<Velocity> along(std::span<const Point> path, std::span<const Obstacle> obstacles,
                                const Velocity& before = {}) const;
  double along_m() const { return options_.speed_mps * options_.horizon_s + 0.3; }
  /// How far the robot can go straight along a bearing, at most `most_m`.
  double room_m(double bearing_rad, std::span<const Point> obstacles, double most_m) const;

 private:
  using Left = std::function<double(const MotionPrimitive&)>;
  std::optional<Velocity> cheapest(const Left& left_m, std::span<const Obstacle> obstacles,
                                   const Velocity& before) const;
  double misdirection_m(const Pose2& end, const Point& target) const;

  MotionOptions options_;
  std::vector<MotionPrimitive> primitives_;
};

}  // namespace opal::navigation
