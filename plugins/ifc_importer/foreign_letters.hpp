#pragma once

#include <string>

namespace opal::ifc_importer {

/// A STEP text in which letters beyond ASCII stand as STEP encodes them ("\X2\00E4\X0\"). Many programs write them as
/// UTF-8, and some in an 8-bit code page, which is taken for ISO 8859-1.
std::string with_codes(std::string text);

}  // namespace opal::ifc_importer
