#pragma once

#include "python/values/arrays.hpp"

#include <opal/map/semantic_map.hpp>

#include <optional>
#include <string>

namespace opal::python {

/// The features of one shape, a row each, in the order of the map. @param type, sensor  only of these.
Array shape_table(const SemanticMap& map, GeometryKind kind, const std::optional<std::string>& type,
                  const std::optional<std::string>& sensor);

}  // namespace opal::python
