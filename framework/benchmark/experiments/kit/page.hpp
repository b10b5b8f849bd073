#pragma once

#include <string>

namespace opal::experiments {

/// A page that stands alone: no script, nothing fetched. @param body  HTML.
std::string page_of(const std::string& title, const std::string& body);

/// @param caption  text, not HTML.
std::string figure(const std::string& svg, const std::string& caption, const std::string& kind = "");

/// What the colours below a plot over time mean. HTML.
std::string status_legend();

}  // namespace opal::experiments
