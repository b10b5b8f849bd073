#pragma once

#include <opal/common/geometry.hpp>

#include <span>
#include <vector>

namespace opal {

/// Twice the area of a polygon by its perimeter [m]: of something long with a constant thickness, that thickness.
/// @param rings  the outline, then its holes; no point twice at the end of a ring.
double mean_thickness_m(std::span<const std::vector<Point>> rings);

}  // namespace opal
