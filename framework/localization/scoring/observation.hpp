#pragma once

#include <opal/localization/scoring/score.hpp>
#include <opal/sensing/scan.hpp>

#include <span>
#include <vector>

namespace opal {

struct ThinnedScan {
  std::vector<Point> points;  ///< base_link frame
  std::vector<int> beams;     ///< the number of each point's beam
};

/// Points such that neighbours in scan order are at least spacing_m apart, at most `most` of them, spread evenly over
/// the scan.
OPAL_EXPORT ThinnedScan thinned(const std::vector<ScanPoint>& points, const Pose2& T_base_laser, double spacing_m,
                                std::size_t most);

/// What hypotheses are judged by now: the scan, thinned, and the features that detectors found in it.
/// @param features  frame of the laser.
OPAL_EXPORT Observation observe(const LocalMap& local_map, const Scan& scan, const Pose2& T_base_laser,
                                std::span<const Feature> features);

/// At most `most` bearings, evenly chosen, turned from the laser's frame to the base's.
OPAL_EXPORT std::vector<double> thinned_bearings(const std::vector<double>& bearings_rad, const Pose2& T_base_laser,
                                                 std::size_t most);

}  // namespace opal
