#include "detector.hpp"

namespace opal::lines {

std::vector<Feature> LineDetector::detect(const Scan& scan) const {
  std::vector<Feature> walls;
  for (const Line& line : extract_lines(chained(scan, options_.chain), options_)) {
    Feature& wall = walls.emplace_back();
    wall.type = "opal:Wall";
    wall.geometry = line.segment;
    wall.covariance.topLeftCorner<2, 2>() = line.covariance;
    wall.true_end = line.true_end;
    wall.support_m = line.support_m;
  }
  return walls;
}

}  // namespace opal::lines
