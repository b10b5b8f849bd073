#include "localization/observation/seen_features.hpp"

#include "sensing/finite_geometry.hpp"

namespace opal {

SeenFeatures detect(const std::vector<Named<FeatureDetector>>& detectors, const Sample& sample,
                    PluginFailures& failures) {
  SeenFeatures seen;
  for (std::size_t k = 0; k < sample.views.size(); ++k)
    for (const auto& detector : detectors)
      failures.guard(detector.name, [&] {
        for (const Feature& feature : detector.part->detect(sample.views[k].scan)) {
          if (!is_finite(feature.geometry)) {
            failures.count(detector.name, "a feature that is not finite");
            continue;
          }
          seen.features.push_back(transformed(sample.views[k].T_base_laser, feature));
          seen.views.push_back(static_cast<int>(k));
        }
      });
  return seen;
}

}  // namespace opal
