#pragma once

#include "simulation/drives/recording.hpp"

namespace opal::simulation {

/// Drives one after the other, as one recording: each begins a while after the one before.
class DriveRecording {
 public:
  /// @param laser  of the robot.
  explicit DriveRecording(const LaserModel& laser);

  /// A scan of the drive that goes on, with its truth. The clock of each drive begins at 0.
  void witness(RawScan scan, const Pose2& T_map_base);
  /// The drive has ended, and counts. @param driven_m  in all.
  void end_drive(std::uint64_t seed, double driven_m);
  /// The drives that ended; scans of the one that goes on are left out.
  Recording ended() const;

 private:
  Recording recording_;
  double begin_s_ = 0, end_s_ = 0;
};

}  // namespace opal::simulation
