#pragma once

#include <optional>
#include <string>

namespace opal {

/// A unit of length in which plans are drawn.
struct LengthUnit {
  std::string name;   ///< "mm"
  double metres = 1;  ///< its length [m]
};

/// @param name  "m", "dm", "cm", "mm", "in", "ft", "yd", or a length in metres such as "0.05". None for other names.
std::optional<LengthUnit> length_unit_called(const std::string& name);
/// All names, for messages: "m, dm, ..., or its length in metres".
std::string length_unit_names();
/// Units in which things would be as long as they are expected to be, for messages: "; in cm they would be 0.90 m
/// (--set unit=cm)", one after the other; empty if there is none.
/// @param drawn  their length as drawn, in the unit of the plan. @param least_m, most_m  what is expected [m].
std::string length_units_that_fit(double drawn, double least_m, double most_m);

}  // namespace opal
