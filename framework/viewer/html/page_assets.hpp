#pragma once

#include <string_view>

namespace opal {

// The page's sources (viewer/page), put into the program when it is built.
extern const std::string_view kPageIndex;  ///< HTML with marks for what is put in
extern const std::string_view kPageStyle;
extern const std::string_view kPageScript;  ///< all modules in one

}  // namespace opal
