#pragma once

#include <opal/sensing/feature_detector.hpp>
#include <opal/sensing/lines/line_extraction.hpp>

namespace opal::corners {

struct CornerOptions {
  LineExtractionOptions lines;
  JunctionOptions junction;
  double min_arm_m = 0.3;  ///< of either line, between its outermost points
};

/// Where two faces meet, as oriented points of type opal:Corner: concave ones and convex ones.
class CornerDetector : public FeatureDetector {
 public:
  explicit CornerDetector(const CornerOptions& options) : options_(options) {}
  std::vector<Feature> detect(const Scan& scan) const override;

 private:
  CornerOptions options_;
};

}  // namespace opal::corners
