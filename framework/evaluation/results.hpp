#pragma once

#include <opal/common/geometry.hpp>
#include <opal/localization/decision/pose_estimate.hpp>

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

namespace opal {

/// One row of a benchmark's result: what was said about one scan.
struct ResultRow {
  std::string query;
  double stamp_s = 0;
  Pose2 T_map_laser;  ///< the laser's pose, not the robot's
  Status status = Status::searching;
  double probability = 0;   ///< that the pose is right
  double none = 1;          ///< that neither this place nor any alternative is right
  std::string storey = {};  ///< id; empty if the map holds no storeys

  bool localized() const { return status == Status::localized; }  ///< the program calls the pose localized
};

/// Another place that the same scan may have been taken at.
struct AlternativeRow {
  std::string query;
  double stamp_s = 0;
  Pose2 T_map_laser;
  double probability = 0;
};

/// Writes a CSV table `query_id,timestamp,x,y,theta,localized_flag,probability,none,status` [s, m, rad] with its
/// header, and a column `storey` behind if any row names one. What is not finite is left out.
OPAL_EXPORT void write_results(std::ostream& out, std::span<const ResultRow> rows);
/// Writes a CSV table `query_id,timestamp,x,y,theta,probability` [s, m, rad] with its header.
OPAL_EXPORT void write_alternatives(std::ostream& out, std::span<const AlternativeRow> rows);

/// Read what was written, columns by name in any order; others are not looked at.
/// @throws LogError naming the file, the line, what was found and what was expected.
OPAL_EXPORT std::vector<ResultRow> read_results(const std::string& path);
OPAL_EXPORT std::vector<AlternativeRow> read_alternatives(const std::string& path);

}  // namespace opal
