#pragma once

#include "simulation/simulation.hpp"

#include <filesystem>
#include <string>

namespace opal::cli {

/// Draws where the simulated robot can be, with coordinates, and a place that was refused; as floor.svg and floor.png.
/// @param folder  is made.
/// @return path of floor.svg.
std::string draw_floor(const simulation::Simulation& simulation, const Point& refused,
                       const std::filesystem::path& folder);

}  // namespace opal::cli
