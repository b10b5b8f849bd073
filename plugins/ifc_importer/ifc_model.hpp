#pragma once

#include "building.hpp"
#include "step_text.hpp"

namespace opal::ifc_importer {

/// Makes a building of a looked-over STEP text. What IfcPlusPlus is used for, and its pitfalls, stay behind this
/// function.
/// @param name  stands for the file in messages.
/// @param origin_m  what lies here in the model is at (0, 0) in the map.
/// @throws MapError if the text holds no building that can be used.
Building read_building(const StepText& step, const std::string& name, const Point& origin_m);

}  // namespace opal::ifc_importer
