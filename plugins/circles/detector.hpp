#pragma once

#include <opal/sensing/feature_detector.hpp>
#include <opal/sensing/lines/line_extraction.hpp>

namespace opal::circles {

struct CircleOptions {
  ChainOptions chain{.gap_m = 0.12, .gap_per_spacing = 3, .max_missing_beams = 1};
  ReadingNoise noise{};
  double min_radius_m = 0.1;
  double max_radius_m = 0.6;
  int min_points = 6;
  double max_rms_m = 0.03;  ///< distance of the points from the circle
  double min_jump_m = 0.2;  ///< beams beside the arc go at least this much farther
  double max_radius_sigma_m = 0.05;
};

/// Round columns that stand free, as circles of type opal:Column.
class CircleDetector : public FeatureDetector {
 public:
  explicit CircleDetector(const CircleOptions& options) : options_(options) {}
  std::vector<Feature> detect(const Scan& scan) const override;

 private:
  CircleOptions options_;
};

}  // namespace opal::circles
