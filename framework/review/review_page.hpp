#pragma once

#include "review/review.hpp"

#include <optional>
#include <string>
#include <vector>

namespace opal {

/// The program that a page tells its decisions.
struct PageServer {
  std::string token;  ///< that the page shows it
  ReviewFiles files;  ///< that it writes
};

/// What was said of each proposal, in their order; null: nothing.
nlohmann::ordered_json answers_of(const Review& review);

/// The page of a review: HTML that stands alone. Nothing in a map or in evidence becomes markup or script.
/// @param notes   sentences above everything. @param server  absent: the page saves its decisions as a file.
/// @throws Error if it would be larger than a browser opens gladly.
std::string review_page(const Review& review, const std::vector<std::string>& notes,
                        const std::optional<PageServer>& server);

}  // namespace opal
