#pragma once

#include <opal/common/export.hpp>
#include <opal/sensing/scan.hpp>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

namespace opal {

/// When the beams of one scan were measured, after its stamp.
struct Sweep {
  double angle_min_rad = 0, angle_increment_rad = 0;  ///< of the beams as recorded
  int beams = 0;
  double beam_s = 0;                ///< from one beam to the next; 0: all at once
  std::vector<float> times_s = {};  ///< of each beam, where beams do not follow each other evenly
  double last_s = 0;                ///< the greatest of them

  bool takes_time() const { return (beam_s > 0 && beams > 1) || last_s > 0; }
  double duration_s() const { return times_s.empty() ? std::max(0.0, beam_s * (beams - 1)) : last_s; }
  /// Of a beam by its index, after the scan's stamp [s].
  double time_of_beam(int beam) const {
    return times_s.empty() ? beam * beam_s : double{times_s[static_cast<std::size_t>(beam)]};
  }
  /// Of a beam in this direction, after the scan's stamp [s].
  double time_of(double bearing_rad) const;
};

/// @return the sweep as the laser's description has it, or as the record states it.
Sweep sweep_of(const RawScan& raw, const LaserModel& laser);

/// Whether a sweep can take so long, of a laser that scans once in `interval_s` (0: not known). Some drivers state a
/// time_increment in another unit.
OPAL_EXPORT bool is_possible_sweep(double sweep_s, double interval_s);
/// A sweep whose time_increment cannot be true would hold its scan back and move its returns: it takes no time then.
/// What the laser's description states is kept. @return whether it was changed.
bool drop_impossible_times(Sweep& sweep, const LaserModel& laser, double interval_s);

/// The pose of base_link in a fixed frame, so many seconds after the scan's stamp; none if it is not known.
using MotionInSweep = std::function<std::optional<Pose2>(double later_s)>;

/// Moves every return to where it is seen from the laser's place at the scan's stamp. A robot that turns 1 rad/s smears
/// a sweep of 0.1 s over 6 degrees (Zhang and Singh 2014, "LOAM", section V). Beams that met nothing are turned.
/// Nothing changes if the sweep takes no time, or the motion is not known.
void deskew(Scan& scan, const Sweep& sweep, const Pose2& T_base_laser, const MotionInSweep& T_fixed_base);

}  // namespace opal
