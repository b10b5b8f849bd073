#pragma once

#include "simulation/clutter.hpp"
#include "simulation/floor.hpp"
#include "simulation/laser.hpp"
#include "simulation/motion_memory.hpp"
#include "simulation/odometry.hpp"
#include "simulation/walker.hpp"

#include <memory>
#include <optional>

namespace opal::simulation {

struct SimulationOptions {
  LaserModel laser = default_laser();   ///< the first one: poses are told of it
  std::vector<LaserModel> more_lasers;  ///< those beside it
  LaserErrors laser_errors;
  Drive drive = Drive::differential;
  OdometryErrors odometry_errors;
  ClutterOptions clutter;
  std::vector<Solid> furniture;  ///< what else stands there, frame `map`
  int people = 4;
  double doors_open_share = 0.7;
  double robot_radius_m = 0.3;
  bool outdoors = false;  ///< robots can be outdoors; outer doors may be open, too

  /// Scans with the lasers of a robot: at least one.
  void take(const std::vector<LaserModel>& lasers) {
    laser = lasers.front();
    more_lasers.assign(lasers.begin() + 1, lasers.end());
  }

  /// 270 degrees in steps of half a degree, up to 30 m, 0.2 m before the robot's centre.
  static LaserModel default_laser();
};

/// What a robot that goes on would touch.
struct Contact {
  Geometry what = Segment{};  ///< frame `map`
  bool person = false;
};

/// One robot in one building with what stands and walks there. The same building, options and seed give the same world
/// and, driven alike, the same readings. Frames as in REP 105; time begins at 0.
class Simulation {
 public:
  /// @throws MapError if the building has no floor for the robot.
  Simulation(std::shared_ptr<const SemanticMap> building, const SimulationOptions& options, std::uint64_t seed);

  const SemanticMap& building() const { return *building_; }
  const SimulationOptions& options() const { return options_; }
  /// Where the robot can be.
  const Floor& floor() const { return *floor_; }
  /// What of the building's ground robots can be on, if nothing stands there.
  const BuildingGround& ground() const { return *ground_; }
  /// From the centre of a robot on the floor to the nearest solid thing, at least.
  double clearance_m() const { return options_.robot_radius_m + kMargin_m; }
  const RayCaster& solids() const { return *solids_; }
  /// What stands where the map does not have it: clutter, and doors that are open. Frame `map`.
  std::vector<Geometry> unmapped() const;
  const std::vector<Walker>& people() const { return people_; }

  double now_s() const { return now_s_; }
  const Pose2& T_map_base() const { return T_map_base_; }
  Pose2 T_map_laser() const { return T_map_base_ * options_.laser.T_base_laser; }
  const Pose2& T_odom_base() const { return odometry_.T_odom_base(); }

  /// Carries the robot away; odometry does not notice.
  void place(const Pose2& T_map_base);
  /// Time goes on, and people walk; the robot moves unless it would touch something.
  /// @return what it would have touched.
  std::optional<Contact> drive(const Velocity& velocity, double duration_s);
  /// The robot is led to a pose by a time, whatever stands in the way; odometry counts it, people walk.
  void follow(const Pose2& T_map_base, double stamp_s);
  /// The sweep of a laser that ends now; its stamp and its odometry are those of its first beam.
  /// @param laser  0: the first one; k: the k-th of more_lasers.
  RawScan scan(std::size_t laser = 0);
  /// Where the robot was, during the sweep that ends now.
  Pose2 T_map_base_at(double stamp_s) const;

 private:
  static constexpr double kMargin_m = 0.1;  ///< so that a way along the centres of cells is a way

  std::unique_ptr<const RayCaster> furnished();
  std::optional<Contact> contact(const Pose2& T_map_base) const;
  bool nears(const Geometry& touched, const Point& next) const;
  const LaserModel& laser(std::size_t number) const {
    return number == 0 ? options_.laser : options_.more_lasers[number - 1];
  }
  double longest_sweep_s() const;
  void remember();

  std::shared_ptr<const SemanticMap> building_;
  SimulationOptions options_;
  Random random_;
  std::unique_ptr<const BuildingGround> ground_;
  std::unique_ptr<const Floor> floor_;  // found while solids_ are put up
  std::vector<Solid> clutter_;          // likewise
  std::unique_ptr<const RayCaster> solids_;
  std::vector<Walker> people_;
  WheelOdometry odometry_;
  Pose2 T_map_base_;
  double now_s_ = 0;
  MotionMemory moved_;  ///< over a sweep
};

}  // namespace opal::simulation
