#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace opal {

/// The sources of a page that is more than a report.
struct PageTemplate {
  std::string_view index;  ///< HTML with the marks `<!-- opal:style -->`, `<!-- opal:data -->`, `<!-- opal:script -->`
  std::string_view style, script;
};

/// The page with its data in place, under a policy by which nothing but its own style and script counts, and nothing is
/// fetched but from the server that it came from.
/// @param data  HTML, put in as it is.
std::string filled_page(const PageTemplate& page, const std::string& data);

/// JSON as the content of a script element: nothing in it can begin or end one. Bytes that are no UTF-8 are replaced.
std::string json_in_html(const nlohmann::ordered_json& json);

}  // namespace opal
