#pragma once

#include <opal/sensing/feature_detector.hpp>
#include <opal/sensing/lines/line_extraction.hpp>

namespace opal::lines {

/// Straight faces as segments of type opal:Wall, each seen from its left.
class LineDetector : public FeatureDetector {
 public:
  explicit LineDetector(const LineExtractionOptions& options) : options_(options) {}
  std::vector<Feature> detect(const Scan& scan) const override;

 private:
  LineExtractionOptions options_;
};

}  // namespace opal::lines
