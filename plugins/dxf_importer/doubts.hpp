#pragma once

#include "closed_doors.hpp"

#include <opal/import_kit/plan_assembly.hpp>

#include <string>
#include <vector>

namespace opal::dxf_importer {

/// What a person should look at: each a sentence that begins with "doubtful", with the ids of the first things.
/// @param strokes       all that may be doors.
/// @param unit_of_file  "mm", if the file says its unit; empty: a person does.
std::vector<std::string> doubts_about(const std::vector<PlanElement>& elements, const std::vector<DoorStroke>& strokes,
                                      const PlanAssembly& assembly, const PlanOptions& options,
                                      const std::string& unit_of_file);

}  // namespace opal::dxf_importer
