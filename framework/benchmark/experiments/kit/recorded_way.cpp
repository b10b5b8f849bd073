#include "benchmark/experiments/kit/recorded_way.hpp"

#include <algorithm>

namespace opal::experiments {

RecordedWay::RecordedWay(const simulation::Recording& recording, double from_s) : recording_(recording) {
  double driven_m = 0;
  const Pose2* before = nullptr;
  for (const simulation::RecordedScan& scan : recording.scans) {
    const bool counts = before != nullptr && scan.scan.stamp_s > from_s;
    if (counts && !simulation::was_kidnapped(*before, scan.T_map_base))
      driven_m += distance_m(*before, scan.T_map_base);
    driven_m_.push_back(driven_m);
    before = &scan.T_map_base;
  }
}

std::size_t RecordedWay::number(double stamp_s) const {
  const auto& scans = recording_.scans;
  const auto after = std::lower_bound(scans.begin(), scans.end(), stamp_s - 1e-6,
                                      [](const auto& scan, double stamp) { return scan.scan.stamp_s < stamp; });
  return static_cast<std::size_t>(std::min(after, scans.end() - 1) - scans.begin());
}

}  // namespace opal::experiments
