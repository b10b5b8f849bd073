#include "simulation/drives/recording.hpp"

#include <algorithm>

namespace opal::simulation {
namespace {

/// A record with the time at which it is known.
struct Known {
  double at_s;
  LogRecord record;
};

double sweep_of(const RawScan& scan, const Recording& recording) {
  for (const LaserModel& laser : recording.more_lasers)
    if (laser.frame == scan.frame) return laser.sweep_s.value_or(0);
  return recording.laser.sweep_s.value_or(0);
}

void add(std::vector<Known>& known, const Recording& recording) {
  for (const OdometryRecord& odometry : recording.odometry) known.push_back({odometry.stamp_s, odometry});
  for (const RecordedScan& recorded : recording.scans) {
    const RawScan& scan = recorded.scan;
    if (recording.odometry.empty())
      known.push_back({scan.stamp_s, OdometryRecord{scan.stamp_s, scan.T_odom_base.value_or(Pose2())}});
    known.push_back({scan.stamp_s + recording.laser.sweep_s.value_or(0), scan});
  }
  for (const RawScan& scan : recording.more_scans) known.push_back({scan.stamp_s + sweep_of(scan, recording), scan});
}

}  // namespace

std::vector<LogRecord> records_of(const Recording& recording) {
  std::vector<Known> known;
  add(known, recording);
  std::ranges::stable_sort(known, {}, &Known::at_s);
  std::vector<LogRecord> records;
  for (Known& each : known) records.push_back(std::move(each.record));
  return records;
}

}  // namespace opal::simulation
