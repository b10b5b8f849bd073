#pragma once

#include "simulation/drives/recording.hpp"

#include <limits>
#include <vector>

namespace opal::experiments {

/// Truth and driven way of a recording by stamp, which is that of a scan, or the next one's; being kidnapped, or
/// carried by a lift from sheet to sheet, is no driving.
class RecordedWay {
 public:
  /// @param recording  must outlive this. @param from_s  what is driven before does not count.
  explicit RecordedWay(const simulation::Recording& recording,
                       double from_s = -std::numeric_limits<double>::infinity());

  const Pose2& truth(double stamp_s) const { return recording_.scans[number(stamp_s)].T_map_base; }
  double driven_m(double stamp_s) const { return driven_m_[number(stamp_s)]; }
  double all_m() const { return driven_m_.empty() ? 0 : driven_m_.back(); }

 private:
  std::size_t number(double stamp_s) const;

  const simulation::Recording& recording_;
  std::vector<double> driven_m_;  ///< by scan
};

}  // namespace opal::experiments
