#pragma once

#include "python/values/arrays.hpp"

#include <opal/map/view/map_view.hpp>

namespace opal::python {

/// Questions to a map about many points at once: shape (..., 2) in, shape (...) out; without the lock of Python.
Array clearances(const MapView& map, const GivenArray& points);
Array likelihoods(const MapView& map, const GivenArray& points);
IntArray nearest_facing(const MapView& map, const GivenArray& points, const GivenArray& viewer);
pybind11::tuple first_crossings(const MapView& map, const GivenArray& origin, const GivenArray& targets,
                                double min_penetration_m);

}  // namespace opal::python
