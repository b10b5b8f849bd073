#pragma once

#include <opal/map_view.hpp>

#include <functional>
#include <vector>

namespace opal {

/// Numbers of the surfaces whose bounding boxes touch the rectangle from `low` to `high` (map frame [m]).
using SurfacesInBox = std::function<std::vector<int>(const Point& low, const Point& high)>;

/// Sets Surface::line of all surfaces that have a size: the longest face that has no line yet begins one, and takes the faces
/// that lie on it (within 0.2 m), run along it (within 0.15 rad), and are at most 30 m beyond its ends. Unlike support_lines(),
/// which joins walls to what a laser may see as one, a line neither grows nor moves by what it takes.
void number_lines(std::vector<Surface>& surfaces, const SurfacesInBox& in_box);

}  // namespace opal
