#pragma once

namespace opal {

/// CPU time per stage of one update [s], in pipeline order.
struct StageTimes {
  double sensor_s = 0,  ///< holds the sensor description against the drive, since the update before
      detect_s = 0,     ///< finds features in the scan
      local_map_s = 0,  ///< matches the scan, associates features, optimizes the local map
      associate_s = 0,  ///< searches the map for new hypotheses, grows those that are alive
      verify_s = 0,     ///< checks these by scans seen before
      track_s = 0,      ///< scores the hypotheses that are alive
      status_s = 0;     ///< decides what is known of the pose
  /// All stages together [s].
  double total_s() const { return sensor_s + detect_s + local_map_s + associate_s + verify_s + track_s + status_s; }
};

}  // namespace opal
