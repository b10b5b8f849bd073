#pragma once

#include "localization/observation/observation.hpp"

#include <vector>

namespace opal {

// A few points, far apart, rank poses nearly as all of them do.
inline constexpr std::size_t kCoarsePoints = 40;
inline constexpr double kCoarseSpacing_m = 0.2;

/// The points of all scans by which many poses are ranked; base_link frame.
inline std::vector<Point> coarse_points(const Sample& sample) {
  return thinned_points(sample, kCoarseSpacing_m, kCoarsePoints);
}

}  // namespace opal
