#pragma once

#include "simulation/simulation.hpp"

#include <filesystem>
#include <string>

/// Draws where the simulated robot can be, with coordinates, and a place that was refused; as floor.svg and floor.png.
/// @param folder  is made.
/// @return path of floor.svg.
std::string draw_floor(const opal::simulation::Simulation& simulation, const opal::Point& refused,
                       const std::filesystem::path& folder);
