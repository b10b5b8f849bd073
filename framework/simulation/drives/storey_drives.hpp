#pragma once

#include "simulation/drives/recording.hpp"

#include <cstdint>

namespace opal::simulation {

/// Drives on storey after storey of a map that holds several, as one recording; between drives, the robot is carried to
/// the next storey, and odometry does not notice. Truth is in the map frame.
/// @param drives  `drives` of them in all, each a query.
/// @throws ConfigError if the map holds no storeys.
Recording record_on_storeys(const SemanticMap& building, const SimulationOptions& world, const DriveOptions& drives,
                            std::uint64_t seed);

}  // namespace opal::simulation
