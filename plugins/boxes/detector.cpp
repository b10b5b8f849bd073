#include "detector.hpp"

#include <opal/sensing/lines/line_corner.hpp>

#include <algorithm>

namespace opal::boxes {
namespace {

/// Whether the far ends of a corner's two sides are true ends, and not where the next face begins (a
/// pilaster).
bool is_free_standing(const Junction& corner, const std::vector<Line>& lines, const std::vector<Junction>& meetings) {
  const bool attached = std::any_of(meetings.begin(), meetings.end(), [&](const Junction& meeting) {
    return meeting.before == corner.after || meeting.after == corner.before;
  });
  return !attached && lines[corner.before].true_end[0] && lines[corner.after].true_end[1];
}

}  // namespace

std::vector<Feature> BoxDetector::detect(const Scan& scan) const {
  const ScanChains chains = chained(scan, options_.lines.chain);
  const std::vector<Line> lines = extract_lines(chains, options_.lines);
  const std::vector<Junction> meetings = find_junctions(chains, lines, {});
  std::vector<Feature> boxes;
  for (const Junction& junction : find_junctions(chains, lines, options_.junction)) {
    if (!is_side(lines[junction.before]) || !is_side(lines[junction.after])) continue;
    const LineCorner corner = corner_at(junction, lines);
    const bool convex = corner.geometry.opening_rad > std::numbers::pi;
    if (convex && is_free_standing(junction, lines, meetings))
      boxes.push_back({.type = "opal:PillarCorner", .geometry = corner.geometry, .covariance = corner.covariance});
  }
  return boxes;
}

bool BoxDetector::is_side(const Line& line) const {
  const double length = line.segment.length_m();
  return length >= options_.min_side_m && length <= options_.max_side_m;
}

}  // namespace opal::boxes
