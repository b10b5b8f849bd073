#pragma once

#include "simulation/drives/recording.hpp"

#include <optional>
#include <string>

namespace opal::simulation {

/// How rides in a lift look.
struct RideDriveOptions {
  DriveOptions drive;            ///< scans and speeds
  double before_m = 40;          ///< driven on the storey where the robot starts, at least, before it goes to the lift
  double after_m = 15;           ///< driven on the storey to which it is carried
  double door_s = 3;             ///< the robot stands, and the door is open
  double closed_s = 12;          ///< the door is closed, and the lift goes
  double cabin_m = 1.8;          ///< side of the cabin
  double door_width_m = 1.0;     ///< of its door
  bool is_shaft_mapped = false;  ///< the map has the walls of the lift: no others stand there while the door is open
};

/// When what happened, by the clock of the recording, and where.
struct Ride {
  std::string lift, from, to;  ///< ids
  double stands_s = 0;         ///< the robot has come to rest in the cabin
  double closes_s = 0;         ///< the door
  double opens_s = 0;          ///< on the other storey
  double leaves_s = 0;         ///< the robot drives on
};

struct RideRecording {
  Recording recording;  ///< truth in the map frame, on the sheet of the storey where the robot is
  Ride ride;
};

/// One drive: about a storey, into a lift, to another storey, and on. Odometry shows nothing of the ride. While the
/// robot is near the lift, a cabin stands there that the map does not hold.
/// @param building  holds storeys. @param lift  has landings on both storeys.
/// @return none if the lift's landing cannot be reached on one of the storeys.
/// @throws ConfigError naming storeys or the lift's landings that there are not.
std::optional<RideRecording> record_ride(const SemanticMap& building, const SimulationOptions& world,
                                         const MapConnection& lift, const std::string& from, const std::string& to,
                                         const RideDriveOptions& options, std::uint64_t seed);

}  // namespace opal::simulation
