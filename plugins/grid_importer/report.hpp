#pragma once

#include "vectorizer.hpp"

#include <string>
#include <vector>

namespace opal::grid_importer {

/// Sentences about what was read, what was found, how well it fits and what was left out.
std::vector<std::string> report(const GridDescription& description, const Boundary& boundary, const VectorMap& vectors,
                                double smear_m);

}  // namespace opal::grid_importer
