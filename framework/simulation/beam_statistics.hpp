#pragma once

#include "simulation/ray_caster.hpp"

#include <opal/sensing/scan.hpp>

#include <string>

namespace opal::simulation {

/// What the beams of a recording did, beside what the map makes one expect: to see how near to life a simulation is.
struct BeamStatistics {
  long on_surface = 0;  ///< ended within the margin of the first mapped surface
  long early = 0;       ///< ended before it, or where nothing is mapped
  long through = 0;     ///< went beyond it and came back from something
  long missing = 0;     ///< came back from nothing though something is mapped
  long free = 0;        ///< nothing mapped, nothing met

  long beams() const { return on_surface + early + through + missing + free; }
};

/// @param T_map_laser  where the scan was really taken.
void count_beams(const RawScan& scan, const Pose2& T_map_laser, const LaserModel& laser, const RayCaster& mapped,
                 BeamStatistics& statistics);

/// Two recordings side by side, shares in percent.
std::string side_by_side(const std::string& name_a, const BeamStatistics& a, const std::string& name_b,
                         const BeamStatistics& b);

}  // namespace opal::simulation
