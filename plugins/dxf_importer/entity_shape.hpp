#pragma once

#include "dxf_drawing.hpp"
#include "dxf_record_check.hpp"

#include <string>

namespace opal::dxf_importer {

/// Code 70 as bits; 0 if there is none.
int flags_of(const DxfRecord& record);

/// What dxflib makes of an entity. It gets each one for itself, so that what it passes over, or stumbles over, is known
/// by name.
/// @param trouble  becomes what is wrong with it, if it cannot be used.
/// @throws MapError "PATH:LINE: what was found, what was expected".
DxfShape read_shape(const std::string& path, const DxfEntityRecords& entity, std::string& trouble);

}  // namespace opal::dxf_importer
