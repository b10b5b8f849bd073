#pragma once

#include "dxf_drawing.hpp"

namespace opal::dxf_importer {

/// Whether this reads entities of a type; all others go through dxflib.
bool is_curve(const std::string& type);

/// Reads a SPLINE, an ELLIPSE or an MLINE whose codes have been checked.
/// @param trouble  gets why there is no shape, if there is none.
DxfShape read_curve(const DxfRecord& record, std::string& trouble);

}  // namespace opal::dxf_importer
