#include "simulation/drives/drive_recording.hpp"

#include <string>
#include <utility>

namespace opal::simulation {

DriveRecording::DriveRecording(const LaserModel& laser) { recording_.laser = laser; }

void DriveRecording::witness(RawScan scan, const Pose2& T_map_base) {
  scan.stamp_s += begin_s_;
  end_s_ = scan.stamp_s;
  recording_.scans.push_back({std::move(scan), T_map_base});
}

void DriveRecording::end_drive(std::uint64_t seed, double driven_m) {
  constexpr double kPause_s = 10;
  recording_.queries.push_back({"s" + std::to_string(seed), begin_s_, end_s_});
  recording_.distances_m.push_back(driven_m);
  begin_s_ = end_s_ + kPause_s;
}

Recording DriveRecording::ended() const {
  Recording ended = recording_;
  std::erase_if(ended.scans, [&](const RecordedScan& scan) { return scan.scan.stamp_s >= begin_s_; });
  return ended;
}

}  // namespace opal::simulation
