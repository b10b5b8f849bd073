#pragma once

#include <optional>
#include <string>

namespace opal::dxf_importer {

/// A unit of length, and its size.
struct Unit {
  std::string name;  ///< "mm"
  double metres = 1;
};

/// @param name  "m", "dm", "cm", "mm", "in", "ft", "yd".
std::optional<Unit> unit_called(const std::string& name);
/// The unit that the header variable $INSUNITS stands for; none for 0 (unitless) and those that no building is drawn
/// in.
std::optional<Unit> unit_of_insunits(int code);
/// All names, for messages.
std::string unit_names();

}  // namespace opal::dxf_importer
