#pragma once

#include "common/random.hpp"
#include "simulation/ray_caster.hpp"

#include <opal/sensing/scan.hpp>

#include <functional>
#include <span>

namespace opal::simulation {

/// What a LiDAR gets wrong (Thrun, Burgard and Fox 2005, 6.3).
struct LaserErrors {
  double range_sigma_m = 0.01;
  double range_sigma_share = 0.001;  ///< of the range, added in squares
  double missed_share = 0.02;        ///< beams that come back from nothing though something is there
  double mixed_share = 0.3;          ///< beams between two depths that report one in between
  double mixed_step_m = 0.2;         ///< neighbours that differ by more stand at two depths
  double glass_share = 0.1;          ///< beams that come back from glass; the others go through
};

/// Where the laser is when it measures one beam; frame `map`.
using LaserPath = std::function<Pose2(int beam)>;

/// One sweep along a path; discs are what moves. Ranges beyond `laser.range_max_m` are `no_return_m`.
RawScan swept(const RayCaster& solids, std::span<const Circle> discs, const LaserPath& T_map_laser,
              const LaserModel& laser, const LaserErrors& errors, Random& random);

}  // namespace opal::simulation
