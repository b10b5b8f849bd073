#pragma once

#include <opal/sensing/scan.hpp>

#include <vector>

namespace opal {

/// How far and how finely the outline follows the beams.
struct FreeSpaceOptions {
  double reach_m = 10;        ///< beams that met nothing are followed so far, and longer returns cut there
  double gap_rad = 0.05;      ///< where neighbouring beams are farther apart, nothing is known between them
  double tolerance_m = 0.05;  ///< of the simplification (Douglas and Peucker 1973)
};

/// Outline of what a scan's beams passed through: from the laser to where they ended (Hendrikx 2023, 4.3.6, before it
/// is shrunk). Frame: base_link [m]; counter-clockwise, not closed; empty if the scan has fewer than two beams.
OPAL_EXPORT std::vector<Point> free_space_outline(const Scan& scan, const Pose2& T_base_laser,
                                                  const FreeSpaceOptions& options = {});

}  // namespace opal
