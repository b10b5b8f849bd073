#pragma once

#include <opal/map/view/map_view.hpp>
#include <opal/sensing/scan.hpp>

#include <span>

namespace opal::experiments {

/// How far the storey of a drive can be told from the others, whoever localizes: of the storey that is most like it,
/// the mean share of beams that would end elsewhere there.
/// @param map         holds storeys.
/// @param T_map_base  where the robot was, on one storey. Poses less than half a metre apart count once.
/// @return in [0, 1]; 1 if there is no other storey.
double storey_difference(const MapView& map, std::span<const Pose2> T_map_base, const LaserModel& laser);

}  // namespace opal::experiments
