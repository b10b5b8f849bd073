#pragma once

#include "simulation/drives/path_follower.hpp"
#include "simulation/simulation.hpp"

#include <opal/sensing/log_source.hpp>
#include "evaluation/site.hpp"
#include "sensing/trajectory.hpp"

#include <span>
#include <string>
#include <vector>

namespace opal::simulation {

/// How recorded drives look.
struct DriveOptions {
  int drives = 5;          ///< each from a place of its own, to places drawn one after the other
  double distance_m = 30;  ///< of each
  double scan_every_s = 0.2;
  double pause_s = 10;  ///< between drives, during which the robot is carried to the next start
  PathFollowerOptions follower;
};

/// One reading with the truth.
struct RecordedScan {
  RawScan scan;  ///< with odometry
  Pose2 T_map_base;
};

/// Drives through a building, as a recording of them would be.
struct Recording {
  LaserModel laser;                      ///< the first one
  std::vector<LaserModel> more_lasers;   ///< those beside it
  std::vector<RecordedScan> scans;       ///< of the first laser
  std::vector<RawScan> more_scans;       ///< of the others, by the time at which they end; the frame tells the laser
  std::vector<OdometryRecord> odometry;  ///< of a laser whose sweeps take time: more than one in a sweep; else empty
  std::vector<Query> queries;            ///< one per drive
  std::vector<double> distances_m;       ///< by query
  int stops = 0;                         ///< how often the robot waited for somebody
};

/// The scan as it is in the recording of a robot whose clock and odometry began earlier.
/// @param later_s  the recording's time when the scan's clock was 0. @param T_odom_odom  of the scan's odometry frame.
void carry_on(RawScan& scan, double later_s, const Pose2& T_odom_odom);

/// Id of a recording's query, from 1 on: "q01".
std::string query_name(int number);

Recording record(Simulation& simulation, const DriveOptions& options, Random random);

/// One drive of a given time from one place to others, one after the other and round again; where something stands, the
/// robot goes to a free place nearby, and to any if there is none.
/// @param random  says how the robot is turned at first, and where else it goes.
Recording record_route(Simulation& simulation, const std::vector<Point>& places, double duration_s,
                       const DriveOptions& options, Random random);

/// The same to places that are drawn all over the floor.
Recording record_about(Simulation& simulation, double duration_s, const DriveOptions& options, Random random);

/// One drive from where the robot stands to one place after the other, where it ends, or after a time.
/// @param places  on the floor.
Recording record_way(Simulation& simulation, const std::vector<Point>& places, double most_s,
                     const DriveOptions& options);

/// The same poses at the same times as another recording: one drive.
/// @param T_map_laser  poses of the laser by increasing stamp.
Recording record_along(Simulation& simulation, std::span<const StampedPose> T_map_laser);

/// Whether a robot was moved from one scan to the next otherwise than by driving.
bool was_kidnapped(const Pose2& before, const Pose2& after);

/// Where the robot was; linear between two scans, unless it was kidnapped between them. Before the first scan and
/// after the last one, as at that scan.
Pose2 truth_at(const Recording& recording, double stamp_s);

/// What a robot would have written down, in this order: a scan after its last beam.
std::vector<LogRecord> records_of(const Recording& recording);

/// PREFIX.log.gz, .gt.csv, .info.json, .queries.json as recorded places have them; `name` stands before the ids of
/// queries.
/// @throws Error naming the file that cannot be written.
void write_recording(const Recording& recording, const std::string& prefix, const std::string& name);
/// The same, named by the last part of the prefix.
void write_recording(const Recording& recording, const std::string& prefix);
/// The same beside the map, as PREFIX.map.jsonld and as a grid, PREFIX.map.yaml and .map.pgm; folders are made.
void write_recorded_place(const Recording& recording, const SemanticMap& map, const std::string& prefix);

}  // namespace opal::simulation
