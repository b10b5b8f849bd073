#pragma once

#include "navigation/node.hpp"
#include "simulation/simulation.hpp"

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace opal {

struct ClosedLoopOptions {
  navigation::MotionOptions motion;
  double tick_s = 0.1;     ///< a scan, a look at the localization, a decision
  double most_s = 900;     ///< then it is given up
  double reached_m = 0.5;  ///< the robot must really be this near to the goal
  /// Is shown every scan, with T_map_base in truth.
  std::function<void(const RawScan&, const Pose2&)> witness;
  std::stop_token stop = {};  ///< ends the drive before its end
};

/// What became of one drive.
struct DriveRecord {
  bool reached = false;  ///< it says so, and is there
  bool said_so = false;  ///< the tree has succeeded
  double time_s = 0, driven_m = 0;
  double off_goal_m = 0;  ///< in truth, at the end
  std::string why;        ///< it did not reach the goal, in words; empty: it did
  /// A step that would have touched something, and was not taken.
  struct Collision {
    double stamp_s;
    Pose2 T_map_base;
    Velocity velocity;
    simulation::Contact touched;
  };
  std::vector<Collision> collisions;
  std::optional<double> localized_after_m,
      localized_after_s;  ///< first time that the pose was called localized, and right
  int scans = 0, localized_scans = 0;
  int falsely_localized_scans = 0;  ///< called localized, and wrong
  int unanswered_scans = 0;         ///< localization was not there
  struct Moment {
    double stamp_s;
    Pose2 truth, estimate;  ///< T_map_base
    bool has_pose;
    Status status;
  };
  std::vector<Moment> moments;  ///< by scan
};

/// How a drive ended, in a word for reports: it is there, it says so and is not, or neither.
inline const char* drive_ending(bool reached, bool said_so) {
  return reached ? "reached" : said_so ? "WRONG PLACE" : "GIVEN UP";
}

/// Lets a robot drive to a goal in a simulated building, by a behaviour tree that knows only what localization answers.
/// While it does not answer, the robot stands still, and simulated time goes as fast as the clock.
/// @param localization  begins anew.
/// @param floor  where the map has room for the robot.
/// @param goal   frame `map`.
DriveRecord drive_to_goal(simulation::Simulation& simulation, navigation::Localization& localization,
                          const FloorGrid& floor, navigation::Node& tree, const Point& goal,
                          const ClosedLoopOptions& options = {});
/// The same with a localizer in this process.
DriveRecord drive_to_goal(simulation::Simulation& simulation, Localizer& localizer, const FloorGrid& floor,
                          navigation::Node& tree, const Point& goal, const ClosedLoopOptions& options = {});

}  // namespace opal
