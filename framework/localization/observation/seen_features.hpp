#pragma once

#include "localization/observation/plugin_failures.hpp"

#include <opal/common/named.hpp>
#include <opal/sensing/feature_detector.hpp>
#include <opal/sensing/sample.hpp>

#include <vector>

namespace opal {

/// Features of all scans of a sample.
struct SeenFeatures {
  std::vector<Feature> features;  ///< base_link frame
  std::vector<int> views;         ///< for each of them, its position in Sample::views
};

/// Every detector is asked about every scan: what one laser sees is whole, what two see together is not.
/// @param failures  counts the detectors that throw.
SeenFeatures detect(const std::vector<Named<FeatureDetector>>& detectors, const Sample& sample,
                    PluginFailures& failures);

}  // namespace opal
