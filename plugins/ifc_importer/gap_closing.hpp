#pragma once

#include "plan.hpp"

namespace opal::ifc_importer {

/// Moves corners that lie within a centimetre of another solid's corner or face onto it, so that solids that nearly
/// touch do. Of corners that become one, that stays whose faces would be tilted most; of one solid, only corners nearer
/// than a millimetre become one. Circles stay as they are.
std::vector<PlanSolid> with_gaps_closed(const std::vector<PlanSolid>& solids);

}  // namespace opal::ifc_importer
