#pragma once

#include "simulation/simulation.hpp"

#include <string>

namespace opal {

/// Why the simulated robot cannot be at a place, or cannot get there from the rest of the floor, in words without a
/// full stop: "it lies outdoors", "the door 'D7', 0.65 m wide, is narrower than the robot with its margin, 0.80 m".
/// Empty: it can. @param place  frame `map`.
std::string why_not_at(const simulation::Simulation& simulation, const Point& place);

}  // namespace opal
