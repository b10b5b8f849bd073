#pragma once

namespace opal {

/// CPU time per stage of one update [s], in pipeline order.
struct StageTimes {
  double sensor_s = 0;      ///< holds the sensor description against the drive, since the update before
  double detect_s = 0;      ///< finds features in the scan
  double local_map_s = 0;   ///< matches the scan, associates features, optimizes the local map
  double track_s = 0;       ///< aligns and scores the hypotheses that are alive
  double generate_s = 0;    ///< generates candidates: from patterns, and about a hint
  double search_s = 0;      ///< aligns and scores candidates by the newest scan
  double retrospect_s = 0;  ///< verifies candidates by earlier scans, and spawns hypotheses
  double grow_s = 0;        ///< grows the association tree by stable local features
  double status_s = 0;      ///< decides what is known of the pose
  /// All stages together [s].
  double total_s() const {
    return sensor_s + detect_s + local_map_s + track_s + generate_s + search_s + retrospect_s + grow_s + status_s;
  }
};

}  // namespace opal
