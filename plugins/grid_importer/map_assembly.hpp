#pragma once

#include "vectorizer.hpp"

#include <opal/map/semantic_map.hpp>

#include <memory>
#include <string>

namespace opal::grid_importer {

/// Names things and puts them into the map frame. Faces joined by corners are one object, the longest first:
/// "wall-0001" with "wall-0001/face-2" and "corner-0007"; what is round, or small and convex all around, is a column.
std::shared_ptr<const SemanticMap> assemble(const std::string& name, const VectorMap& vectors,
                                            const OccupancyGrid& grid, double smear_m);

}  // namespace opal::grid_importer
