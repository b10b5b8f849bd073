#include "jsonld/json_ld.hpp"

#include "jsonld/expansion/expansion.hpp"

#include <utility>

namespace opal::json_ld {

JsonLdError::JsonLdError(std::string code, std::string pointer, const std::string& detail)
    : MapError((pointer.empty() ? "(root)" : pointer) + ": " + code + ": " + detail),
      code_(std::move(code)),
      pointer_(std::move(pointer)) {}

JsonLdError::~JsonLdError() = default;

nlohmann::json expand(const nlohmann::json& document, const Options& options) {
  return Expander(options).expand_document(document);
}

}  // namespace opal::json_ld
