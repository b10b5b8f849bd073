#pragma once

#include "step_text.hpp"

#include <string>
#include <vector>

namespace opal::ifc_importer {

/// Takes away the side information that refers to nothing or in a circle (space boundaries may), and every instance
/// that only such information needs. References to what was taken away go, too, so that the rest is sound.
/// @param is_cut_off  the file ends among its instances: parts of the building that need what is missing go, too, and
/// relations lose the members that do.
/// @return sentences about what was left out.
/// @throws MapError if a part of the building itself refers in a circle, or, in a file that is not cut off, to nothing.
std::vector<std::string> leave_out_unsound(std::vector<StepInstance>& instances, const std::string& name,
                                           bool is_cut_off = false);

}  // namespace opal::ifc_importer
