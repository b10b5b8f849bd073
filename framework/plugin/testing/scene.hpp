#pragma once

#include <opal/common/feature.hpp>
#include <opal/sensing/scan.hpp>

#include <span>
#include <string>
#include <vector>

namespace opal::testing {

/// A sweep as a laser would make it: 541 beams over 270 degrees, up to 12 m, with 1 cm of noise.
/// @param surfaces  in one frame; segments and circles stop beams, other shapes do not.
/// @param T_surfaces_laser  where the laser stands in that frame.
Scan simulated_scan(std::span<const Geometry> surfaces, const Pose2& T_surfaces_laser, unsigned seed);

/// The scan as the sensor would see it from the same place after the world was turned about it.
/// @param turn_rad  such that no bearing passes pi.
Scan turned(const Scan& scan, double turn_rad);

/// Bounded faces of a closed polygon, visible from its inside.
std::vector<Geometry> room(const std::vector<Point>& corners_counter_clockwise);

/// A slanted room, 7 m by 5 m, with a niche, a square pillar and round columns.
std::vector<Geometry> example_room();

bool is_finite(const Pose2& pose);
/// "a segment from (1.20, 3.40) to (2.00, 3.40)"
std::string described(const Geometry& geometry);
/// All numbers finite, and the shape possible: length and radius positive, opening in (0, 2 pi).
bool is_possible(const Geometry& geometry);

}  // namespace opal::testing
