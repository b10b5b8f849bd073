#pragma once

#include <opal/common/strict_json.hpp>

#include <functional>
#include <string>

namespace opal {

/// What happens to each element of one array while a document is parsed, so that a large array is never in memory.
struct JsonElements {
  std::string key;  ///< of the array, in the outermost object
  /// Gets an element once it is whole. @return true: it is left out of the document.
  std::function<bool(nlohmann::json& element)> take;
};

/// parse_json without the elements that were taken. Of what stands behind one of them, messages name another place.
OPAL_EXPORT nlohmann::json parse_json_elements(const std::string& text, const std::string& name,
                                               const JsonElements& elements, const JsonLimits& limits = {});

/// The text of a file. @throws JsonError naming it, also if it is larger than allowed.
OPAL_EXPORT std::string read_json_text(const std::string& path, const JsonLimits& limits = {});

}  // namespace opal
