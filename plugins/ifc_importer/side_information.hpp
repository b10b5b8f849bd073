#pragma once

#include "step_text.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace opal::ifc_importer {

/// Whether instances of a type say something beside the building that becomes map: properties, quantities, space
/// boundaries, colours, owners, documents, schedules, spaces.
/// @param type  "IFCPROPERTYSET".
bool is_side_information(std::string_view type);

/// Takes away the side information that refers to nothing or in a circle (space boundaries may), and every instance
/// that only such information needs. References to what was taken away go, too, so that the rest is sound.
/// @return sentences about what was left out.
/// @throws MapError if a part of the building itself refers to nothing or in a circle.
std::vector<std::string> leave_out_unsound(std::vector<StepInstance>& instances, const std::string& name);

}  // namespace opal::ifc_importer
