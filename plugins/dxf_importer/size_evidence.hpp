#pragma once

#include <opal/import_kit/length_unit.hpp>
#include <opal/import_kit/plan_assembly.hpp>

#include <string>
#include <vector>

namespace opal::dxf_importer {

/// How wide a door is.
struct DoorWidth {
  double width_m = 0;      ///< of its leaf if it has a swing, else of all that is drawn; 0: nothing is
  bool has_swing = false;  ///< an arc shows how far its leaf turns
};
DoorWidth door_width(const PlanElement& door);

/// A sentence that begins with "doubtful", where leaves of doors, or walls, are larger or smaller than any building has
/// them: with what was found, what was expected, and the units in which it would fit. Empty: nothing is odd.
/// @param unit  in which the drawing was read.
std::string doubt_about_size(const std::vector<PlanElement>& elements, const PlanAssembly& assembly,
                             const PlanOptions& options, const LengthUnit& unit);

}  // namespace opal::dxf_importer
