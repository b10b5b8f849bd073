#pragma once

#include <opal/common/feature.hpp>
#include <opal/local_map/local_map.hpp>

#include <vector>

namespace opal {

/// What one laser sees now; base_link frame.
struct ObservedScan {
  Point laser_position = Point::Zero();  ///< where beams start
  std::vector<Point> points = {};        ///< returns, thinned evenly in space by the framework [m]
  /// Directions [rad] that returned nothing up to range_max_m, thinned.
  std::vector<double> free_bearings_rad = {};
  double range_max_m = 0;       ///< how far a beam that returned nothing is known to be free
  std::vector<int> beams = {};  ///< for each of `points`, the number of its beam
  /// For each of `points`, its evidence cell of the local map (LocalMap::evidence_cells): the same for whoever is
  /// judged, and for a scan of before as it was then.
  std::vector<EvidenceCell> evidence_cells = {};
};

/// What hypotheses are judged against: what the robot sees now, with all its lasers.
struct Observation {
  const LocalMap& local_map;            ///< features and pose in the `local` frame, the newest scans included
  std::vector<ObservedScan> scans;      ///< of the lasers that took part
  std::vector<Feature> features = {};   ///< of the newest scans; base_link frame
  std::vector<int> feature_scans = {};  ///< for each of `features`, the position in `scans` of the one that has it

  /// How many returns the scans have together.
  std::size_t points() const {
    std::size_t sum = 0;
    for (const ObservedScan& scan : scans) sum += scan.points.size();
    return sum;
  }
  /// Where the robot stands if a hypothesis is right. @param T_map_local  Hypothesis::T_map_local.
  Pose2 T_map_base(const Pose2& T_map_local) const { return T_map_local * local_map.T_local_base(); }
  /// Where the laser was that saw a feature; base_link frame. @param feature  position in `features`.
  Point viewpoint_of(std::size_t feature) const {
    return scans[static_cast<std::size_t>(feature_scans[feature])].laser_position;
  }
};

}  // namespace opal
