#pragma once

#include "step_text.hpp"

namespace opal::ifc_importer {

/// A parser that follows references must neither fall into a circle nor meet nothing.
/// @throws MapError if two instances have one number, a reference has no instance, instances refer to each other in a
/// circle, or chains of references are so long that no model has them.
void check_references(const std::vector<StepInstance>& instances, const std::string& name);

}  // namespace opal::ifc_importer
