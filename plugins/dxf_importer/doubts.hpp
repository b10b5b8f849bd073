#pragma once

#include "closed_doors.hpp"

#include <opal/import_kit/length_unit.hpp>
#include <opal/import_kit/plan_assembly.hpp>

#include <string>
#include <vector>

namespace opal::dxf_importer {

/// What a person should look at: each a sentence that begins with "doubtful", with the ids of the first things.
/// @param strokes          all that may be doors.
/// @param unit             in which the drawing was read.
/// @param is_unit_of_file  the file says it, and no person does.
std::vector<std::string> doubts_about(const std::vector<PlanElement>& elements, const std::vector<DoorStroke>& strokes,
                                      const PlanAssembly& assembly, const PlanOptions& options, const LengthUnit& unit,
                                      bool is_unit_of_file);

}  // namespace opal::dxf_importer
