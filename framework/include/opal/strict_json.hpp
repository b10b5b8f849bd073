#pragma once

#include <opal/error.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace opal {

struct JsonLimits {
  std::size_t bytes = 64u << 20;
  int depth = 128;
};

/// Text that is no acceptable JSON: not UTF-8, duplicate keys, NaN or infinite numbers, too large, too deep.
class OPAL_EXPORT JsonError : public Error {
 public:
  using Error::Error;
  ~JsonError() override;
};

/// Parses JSON strictly. @throws JsonError "NAME: POINTER: what was found, what was expected" (or line and column
/// for syntax errors).
OPAL_EXPORT nlohmann::json parse_json(const std::string& text, const std::string& name,
                                      const JsonLimits& limits = {});
/// Reads and parses a file. @throws JsonError naming it.
OPAL_EXPORT nlohmann::json read_json(const std::string& path, const JsonLimits& limits = {});

}  // namespace opal
