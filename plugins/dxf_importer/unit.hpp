#pragma once

#include <opal/import_kit/length_unit.hpp>

#include <optional>

namespace opal::dxf_importer {

/// The unit that the header variable $INSUNITS stands for; none for 0 (unitless) and those that no building is drawn
/// in.
std::optional<LengthUnit> unit_of_insunits(int code);

}  // namespace opal::dxf_importer
