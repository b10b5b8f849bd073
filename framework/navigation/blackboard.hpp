#pragma once

#include "navigation/localization_queries.hpp"
#include "navigation/motion_primitives.hpp"
#include "navigation/seen_obstacles.hpp"

#include "map_tools/floor_grid.hpp"

#include <deque>
#include <optional>
#include <vector>

namespace opal::navigation {

/// Where the map has room for a disc (BuildingGround::floor_with_outside). Frame: `map`.
/// @param outdoors  ways may lead out of the building.
/// @throws MapError if there is no such place.
FloorGrid mapped_floor(const MapView& map, double radius_m, bool outdoors = false);

/// What the nodes of a tree know and decide: one moment of a robot with a goal.
class Blackboard {
 public:
  /// What is given must outlive this.
  Blackboard(const LocalizationQueries& queries, const MotionPrimitives& primitives, const FloorGrid& mapped_floor,
             const Point& wanted);

  const LocalizationQueries& localization;
  const MotionPrimitives& motion;
  const FloorGrid& floor;  ///< frame `map`
  const Point goal;        ///< frame `map`
  /// Mapped floor where the robot and its margin do not fit is dear: the map may be wrong there, the robot is not.
  const FloorGrid::Surcharge tight;

  /// Takes what localization now answers; to be called once before every tick.
  void look();
  double now_s() const { return localization.newest_scan().stamp_s; }
  const PoseEstimate& estimate() const { return estimate_; }
  const Pose2& T_odom_base() const { return localization.T_odom_base(); }
  /// From the best hypothesis; only if estimate().has_pose.
  Pose2 T_map_odom() const { return estimate_.T_map_base * T_odom_base().inverse(); }
  const SeenObstacles& obstacles() const { return obstacles_; }
  /// Where the robot has been, and what share of its beams met something there.
  struct Been {
    Point p_odom;
    double met_share;
  };
  const std::vector<Been>& trail() const { return trail_; }  ///< every 0.3 m
  double met_share() const;                                  ///< of the newest scan's beams

  /// What the robot shall do until the next tick; stand still unless a node says otherwise.
  const Velocity& velocity() const { return velocity_; }
  void turn(double radps) { velocity_ = {Point::Zero(), radps}; }
  /// Drives to a place by the best free primitive. @param target  frame odom. @return false if there is none.
  bool drive_towards(const Point& target_odom);
  /// Drives along a path from where the robot is on it. @param path_odom  not empty. @return false if there is no free
  /// primitive.
  bool drive_along(const std::vector<Point>& path_odom);
  /// Wants a local map of the pattern alone (Localization::keep_pattern).
  void keep_pattern() { wants_pattern_alone_ = true; }
  bool wants_pattern_alone() const { return wants_pattern_alone_; }  ///< since `look`
  /// What stands around, frame base_link.
  std::vector<Point> around(double reach_m) const;

  /// Whether the robot has wanted to get somewhere for some seconds, and has not moved.
  bool is_stuck() const { return now_s() - moved_at_s_ > kPatience_s; }
  /// For some minutes there is no way through a place, whatever the plan says. Frame `map`.
  void give_up(const Point& p_map) { bar(p_map, Reason::given_up); }
  /// Where even the best way leads through impasses there is no other: they are tried again. Frame `map`.
  /// @return whether there are such.
  bool try_again(std::span<const Point> way_map);
  /// What stands where the map has nothing, frame `map`: near the robot as it is seen now, farther away as it was seen
  /// last, so that a plan does not forget on its way round a thing what the way round is for.
  std::vector<Point> unmapped() const;
  /// Where the robot has been in the last minutes and knew it, frame `map`: there it can be again, however narrow it
  /// is.
  std::vector<Point> passed() const;
  /// Where it got stuck not long ago, a little way ahead, or gave up, frame `map`: there is no way through.
  std::vector<Point> impasses() const;
  void forget_being_stuck() { moved_at_s_ = now_s(); }

 private:
  static constexpr double kPatience_s = 6;

  struct Impasse {
    Point p_map;
    double until_s;
  };
  struct Stamped {
    Point p_map;
    double stamp_s;
  };
  void leave_out_mapped_berths();
  void notice_progress();
  void notice_impasse();
  /// Why there is no way through a place: the robot did not move, or a node says so.
  enum class Reason { stuck, given_up };
  void bar(const Point& p_map, Reason reason);
  void notice_unmapped();
  void notice_passed();

  PoseEstimate estimate_;
  SeenObstacles obstacles_;
  std::vector<Obstacle> near_;  ///< what the next motion must not touch
  std::vector<Been> trail_;
  Velocity velocity_, before_;
  bool wants_pattern_alone_ = false;
  std::vector<Impasse> impasses_;
  std::vector<Stamped> unmapped_;
  std::deque<Stamped> passed_;  ///< oldest first
  Pose2 T_map_odom_noticed_;    ///< by which unmapped_, passed_ and impasses_ lie in the map
  double noticed_at_s_ = -1e9;
  std::optional<Point> wanted_odom_;  ///< where some node wanted to get at the tick before
  Point moved_from_ = Point::Zero();
  double moved_at_s_ = 0;  ///< or did not want to get anywhere
};

}  // namespace opal::navigation
