#pragma once

#include <opal/map/semantic_map.hpp>

#include <pybind11/pybind11.h>

namespace opal::python {

/// (nodes, edges) of a map: objects, features, the points that features share, patterns.
pybind11::tuple map_graph(const SemanticMap& map);

}  // namespace opal::python
