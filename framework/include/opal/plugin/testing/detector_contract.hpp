#pragma once

#include <opal/plugin/registrar.hpp>
#include <opal/sensing/feature_detector.hpp>

#include <string>
#include <vector>

namespace opal::testing {

/// Scans of synthetic rooms with slanted walls, corners, columns, doorways and clutter: 541 beams over 270
/// degrees, 1 cm of noise, always the same.
OPAL_EXPORT std::vector<Scan> example_scans();

/// What a detector is tried on, besides empty, tiny, huge, degenerate and not-a-number scans.
struct DetectorTrial {
  std::vector<Scan> scans = example_scans();  ///< what the detector sees in turn
  double position_tolerance_m = 1e-3;         ///< between features of a rotated scan and rotated features
  double angle_tolerance_rad = 1e-3;          ///< the same for headings
  bool must_find_something = false;           ///< for authors whose scans hold what they look for
};

/// What every detector promises (feature_detector.hpp): finite features of the types that it says it
/// produces, with covariances; nothing thrown for a poor scan; the same scan gives the same features, also
/// from two threads; a rotated scan gives the rotated features.
/// @return violations, one sentence each; empty for a good citizen.
OPAL_EXPORT std::vector<std::string> detector_violations(const FeatureDetector& detector, const TypeInfo& type,
                                                         const DetectorTrial& trial = {});

}  // namespace opal::testing
