#pragma once

#include <opal/common/geometry.hpp>

#include <string>
#include <vector>

/// One reading of a recorded log.
struct RecordedScan {
  double stamp_s = 0;
  std::vector<double> ranges_m;  ///< by beam
  opal::Pose2 T_odom_laser;      ///< as the log has it
};

/// The FLASER lines of a CARMEN log, packed or not. @throws opal::LogError naming file and line.
std::vector<RecordedScan> read_scans(const std::string& path);
