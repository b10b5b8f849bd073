#pragma once

#include "navigation/node.hpp"
#include "navigation/path_drive.hpp"
#include "navigation/viewpoints.hpp"

#include <optional>
#include <set>

namespace opal::navigation {

/// Turns on the spot by so many turns, counter-clockwise if positive.
class Rotate : public Node {
 public:
  Rotate(double turns, double turn_radps) : turns_(turns), turn_radps_(turn_radps) {}
  NodeStatus tick(Blackboard& blackboard) override;
  void halt() override { before_.reset(); }

 private:
  double turns_, turn_radps_;
  std::optional<Pose2> before_;  ///< odometry at the tick before
  double turned_rad_ = 0;
};

/// Backs away from what is in front. Succeeds when it has, or cannot any more.
class BackOff : public Node {
 public:
  explicit BackOff(double distance_m) : distance_m_(distance_m) {}
  NodeStatus tick(Blackboard& blackboard) override;
  void halt() override { target_odom_.reset(); }

 private:
  double distance_m_;
  std::optional<Point> target_odom_;
  double began_s_ = 0;
};

/// Drives to where there is room, straight on where it can, and rather to where it has not been yet, nor hypotheses
/// have the building end. From the open, where much of the laser meets nothing, it goes back the way it came. Fails
/// where it cannot move for some seconds.
class DriveFreely : public Node {
 public:
  /// @param distance_m  after which it succeeds; 0: never.
  explicit DriveFreely(double distance_m) : distance_m_(distance_m) {}
  NodeStatus tick(Blackboard& blackboard) override;
  void halt() override;

 private:
  Point choose(const Blackboard& blackboard) const;

  double distance_m_;
  std::optional<Point> target_odom_;
  std::optional<Pose2> before_;
  double driven_m_ = 0, chosen_at_s_ = 0, could_move_at_s_ = 0;
  bool was_open_ = false;
};

/// Asks localization to forget of its local map all but the pattern of the best hypothesis. Fails if there is none.
class KeepPattern : public Node {
 public:
  NodeStatus tick(Blackboard& blackboard) override;
};

/// Drives between the first two features of the best hypothesis' pattern, to see both well (Hendrikx 2023, 4.4.2).
/// Fails if there are none, or no way leads there.
class DriveBetweenFeatures : public Node {
 public:
  NodeStatus tick(Blackboard& blackboard) override;
  void halt() override { target_odom_.reset(); }

 private:
  std::optional<Point> target_odom_;
  double began_s_ = 0;
};

/// Drives to the place from which the hypotheses will be told apart soonest. Succeeds when it is there; fails if there
/// are no two hypotheses, or no place is expected to tell them apart.
class Disambiguate : public Node {
 public:
  explicit Disambiguate(const DisambiguateOptions& options) : options_(options) {}
  NodeStatus tick(Blackboard& blackboard) override;
  void halt() override;

 private:
  bool has_new_alternatives(const PoseEstimate& estimate) const;
  bool choose(Blackboard& blackboard);

  DisambiguateOptions options_;
  std::vector<Point> visited_odom_;  ///< places that were expected to help
  std::optional<PathDrive> drive_;
  std::set<HypothesisId> compared_;  ///< hypotheses that were there when the place was chosen
  HypothesisId best_;                ///< of them
  double failed_at_s_ = -1e9;
};

/// Drives to the goal by the best hypothesis, another way if it lingers before something. Succeeds near the goal; fails
/// if there is no pose, or no way.
class GoToGoal : public Node {
 public:
  explicit GoToGoal(double arrived_m) : arrived_m_(arrived_m) {}
  NodeStatus tick(Blackboard& blackboard) override;
  void halt() override { drive_.reset(); }

 private:
  bool plan(Blackboard& blackboard);
  void notice_lingering(const Blackboard& blackboard);

  double arrived_m_;
  std::optional<PathDrive> drive_;
  double planned_at_s_ = 0;
  Point lingering_from_odom_ = Point::Zero();
  double lingering_s_ = 0;  ///< while this node drove the robot, which is still about there
  double ticked_at_s_ = 0;
};

}  // namespace opal::navigation
