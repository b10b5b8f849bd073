#pragma once

#include <opal/sensing/feature_detector.hpp>
#include <opal/sensing/lines/line_extraction.hpp>

namespace opal::boxes {

struct BoxOptions {
  LineExtractionOptions lines{.min_points = 4, .min_length_m = 0.1};
  JunctionOptions junction{.max_end_distance_m = 0.3, .max_extension_m = 0.2, .min_sine = 0.9};
  double min_side_m = 0.1;
  double max_side_m = 1.5;
};

/// Rectangular columns and boxes that stand free, of which two sides are seen: their near edge, as an
/// oriented point of type opal:PillarCorner with an opening of about 3 pi / 2.
class BoxDetector : public FeatureDetector {
 public:
  explicit BoxDetector(const BoxOptions& options) : options_(options) {}
  std::vector<Feature> detect(const Scan& scan) const override;

 private:
  bool is_side(const Line& line) const;

  BoxOptions options_;
};

}  // namespace opal::boxes
