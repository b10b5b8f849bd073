#include "detector.hpp"

#include <opal/sensing/lines/line_corner.hpp>

namespace opal::corners {

std::vector<Feature> CornerDetector::detect(const Scan& scan) const {
  const ScanChains chains = chained(scan, options_.lines.chain);
  const std::vector<Line> lines = extract_lines(chains, options_.lines);
  std::vector<Feature> corners;
  for (const Junction& junction : find_junctions(chains, lines, options_.junction)) {
    const auto arm_m = [&](int line) { return lines[line].segment.length_m(); };
    if (arm_m(junction.before) < options_.min_arm_m || arm_m(junction.after) < options_.min_arm_m) continue;
    const LineCorner corner = corner_at(junction, lines);
    corners.push_back({.type = "opal:Corner", .geometry = corner.geometry, .covariance = corner.covariance});
  }
  return corners;
}

}  // namespace opal::corners
