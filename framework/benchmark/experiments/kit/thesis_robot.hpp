#pragma once

#include "simulation/simulation.hpp"

namespace opal::experiments {

/// 180 degrees, 720 beams, mecanum wheels (Hendrikx 2023, 3.5).
inline simulation::SimulationOptions thesis_robot() {
  simulation::SimulationOptions options;
  options.laser.angle_min_rad = -std::numbers::pi / 2;
  options.laser.beams = 720;
  options.laser.angle_increment_rad = std::numbers::pi / (options.laser.beams - 1);
  options.drive = simulation::Drive::omnidirectional;
  return options;
}

}  // namespace opal::experiments
