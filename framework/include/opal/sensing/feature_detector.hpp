#pragma once

#include <opal/common/feature.hpp>
#include <opal/sensing/scan.hpp>

#include <vector>

namespace opal {

/// Finds features of some types in one scan. Stateless: `detect` is const and may be called from several threads.
class OPAL_EXPORT FeatureDetector {
 public:
  virtual ~FeatureDetector();

  /// @param scan  points [m] in the sensor frame, by increasing bearing; may be empty.
  /// @return features in the sensor frame, covariances filled in; empty if there are none. The same scan gives
  ///         the same features, and a rotated scan the rotated ones.
  virtual std::vector<Feature> detect(const Scan& scan) const = 0;
};

}  // namespace opal
