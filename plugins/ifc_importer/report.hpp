#pragma once

#include "level_choice.hpp"
#include "map_assembly.hpp"

#include <opal/map/map_importer.hpp>

namespace opal::ifc_importer {

/// Every thing of the building, and what became of it.
std::vector<ImportedElement> imported_elements(const std::vector<ElementCut>& cuts, const Duplicates& duplicates,
                                               const AssembledMap& assembled);

/// Sentences: about the model, per class what came in and what did not, about faces, doors and what to look at.
std::vector<std::string> report(const Building& building, const LevelChoice& level, const std::vector<ElementCut>& cuts,
                                const std::vector<ImportedElement>& elements, const Plan& plan,
                                const AssembledMap& assembled);

/// "; cannot be read: 12 things, the first is IfcWall 2cXV28XOjE6f6irgi0CPeU: why"; empty if all can be.
std::string unread(const std::vector<ElementCut>& cuts);

/// Width of the widest door that is cut [m]; 0 without doors.
double widest_door_m(const std::vector<ElementCut>& cuts);

}  // namespace opal::ifc_importer
