#pragma once

#include <string_view>

namespace opal::ifc_importer {

/// Whether instances of a type say something beside the building that becomes map: properties, quantities, space
/// boundaries, colours, owners, documents, schedules, spaces.
/// @param type  "IFCPROPERTYSET".
bool is_side_information(std::string_view type);

}  // namespace opal::ifc_importer
