#include "localization/observation/seen_features.hpp"

#include <cmath>

namespace opal {
namespace {

struct IsFinite {
  bool operator()(const Point& p) const { return p.allFinite(); }
  bool operator()(const OrientedPoint& p) const {
    return p.position.allFinite() && std::isfinite(p.heading_rad) && std::isfinite(p.opening_rad);
  }
  bool operator()(const Segment& s) const { return s.begin.allFinite() && s.end.allFinite(); }
  bool operator()(const Circle& c) const { return c.center.allFinite() && std::isfinite(c.radius_m); }
};

bool is_finite(const Feature& feature) { return std::visit(IsFinite{}, feature.geometry); }

}  // namespace

SeenFeatures detect(const std::vector<Named<FeatureDetector>>& detectors, const Sample& sample,
                    PluginFailures& failures) {
  SeenFeatures seen;
  for (std::size_t k = 0; k < sample.views.size(); ++k)
    for (const auto& detector : detectors)
      failures.guard(detector.name, [&] {
        for (const Feature& feature : detector.part->detect(sample.views[k].scan)) {
          if (!is_finite(feature)) {
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
