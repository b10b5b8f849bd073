#pragma once

#include <string_view>

namespace opal {

// The sources of review/page, put into the program when it is built.
extern const std::string_view kReviewIndex;  ///< HTML with marks for what is put in
extern const std::string_view kReviewStyle;
extern const std::string_view kReviewScript;  ///< all modules in one

}  // namespace opal
