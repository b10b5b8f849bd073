#pragma once

#include "closed_doors.hpp"

#include <opal/import_kit/plan_assembly.hpp>

#include <string>
#include <vector>

namespace opal::dxf_importer {

/// What a person should look at: each a sentence that begins with "doubtful", with the ids of the first things.
/// @param strokes  all that may be doors.
std::vector<std::string> doubts_about(const std::vector<PlanElement>& elements, const std::vector<DoorStroke>& strokes,
                                      const PlanAssembly& assembly, const PlanOptions& options);

}  // namespace opal::dxf_importer
