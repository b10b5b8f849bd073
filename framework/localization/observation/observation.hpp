#pragma once

#include "localization/observation/seen_features.hpp"

#include <opal/localization/observation/observation.hpp>
#include <opal/sensing/sample.hpp>

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

/// What hypotheses are judged by now: the scans, thinned, and the features that detectors found in them.
OPAL_EXPORT Observation observe(const LocalMap& local_map, const Sample& sample, SeenFeatures seen);

/// Points of all scans of a sample, each thinned by itself: at least spacing_m apart, at most `most` in all, shared
/// by how much each scan has to tell.
OPAL_EXPORT std::vector<ThinnedScan> thinned(const Sample& sample, double spacing_m, std::size_t most);
/// The same in one list.
OPAL_EXPORT std::vector<Point> thinned_points(const Sample& sample, double spacing_m, std::size_t most);

/// At most `most` bearings, evenly chosen, turned from the laser's frame to the base's.
OPAL_EXPORT std::vector<double> thinned_bearings(const std::vector<double>& bearings_rad, const Pose2& T_base_laser,
                                                 std::size_t most);

}  // namespace opal
