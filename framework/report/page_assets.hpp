#pragma once

#include <string_view>

namespace opal {

// The sources of report/page, put into the program when it is built.
extern const std::string_view kReportStyle;
extern const std::string_view kReportScript;  ///< all modules in one, with what they use of d3

}  // namespace opal
