#pragma once

#include <opal/common/error.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace opal {

/// How large a text may be before it is refused.
struct JsonLimits {
  std::size_t bytes = 64u << 20;  ///< length of the text
  int depth = 128;                ///< arrays and objects inside each other
};

/// Text that is no acceptable JSON: not UTF-8, duplicate keys, NaN or infinite numbers, too large, too deep.
class OPAL_EXPORT JsonError : public Error {
 public:
  using Error::Error;
  ~JsonError() override;
};

/// Parses JSON (RFC 8259) strictly.
/// @param text  the whole document, in UTF-8.
/// @param name  what the text is called in messages: a file, a URL.
/// @param limits  beyond these, the text is refused.
/// @throws JsonError "NAME: POINTER: what was found, what was expected" (line and column instead of the
/// pointer for syntax errors).
OPAL_EXPORT nlohmann::json parse_json(const std::string& text, const std::string& name, const JsonLimits& limits = {});
/// Reads and parses a file. @throws JsonError naming it.
OPAL_EXPORT nlohmann::json read_json(const std::string& path, const JsonLimits& limits = {});

/// One step of a JSON pointer (RFC 6901, section 3): "a/b~c" becomes "a~1b~0c".
OPAL_EXPORT std::string escape_pointer_step(const std::string& key);

}  // namespace opal
