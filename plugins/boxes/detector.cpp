#include "detector.hpp"

#include <opal/line_corner.hpp>

namespace opal::boxes {

std::vector<Feature> BoxDetector::detect(const Scan& scan) const {
  const ScanChains chains = chained(scan, options_.lines.chain);
  const std::vector<Line> lines = extract_lines(chains, options_.lines);
  std::vector<Feature> boxes;
  for (const Junction& junction : find_junctions(chains, lines, options_.junction)) {
    if (!is_side(lines[junction.before]) || !is_side(lines[junction.after])) continue;
    const LineCorner corner = corner_at(junction, lines);
    const bool convex = corner.geometry.opening_rad > std::numbers::pi;
    const bool free_standing = lines[junction.before].true_end[0] && lines[junction.after].true_end[1];
    if (convex && free_standing)
      boxes.push_back(
          {.type = "opal:PillarCorner", .geometry = corner.geometry, .covariance = corner.covariance});
  }
  return boxes;
}

bool BoxDetector::is_side(const Line& line) const {
  const double length = line.segment.length_m();
  return length >= options_.min_side_m && length <= options_.max_side_m;
}

}  // namespace opal::boxes
