#pragma once

#include <opal/error.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <map>
#include <string>

namespace opal::json_ld {

/// A document that breaks JSON-LD 1.1, or uses a part of it outside the supported subset.
class OPAL_EXPORT JsonLdError : public MapError {
 public:
  /// @param code     W3C error code, e.g. "invalid term definition"; "unsupported: @nest" for what the subset lacks.
  /// @param pointer  JSON pointer into the source document.
  JsonLdError(std::string code, std::string pointer, const std::string& detail);
  ~JsonLdError() override;
  const std::string& code() const { return code_; }
  const std::string& pointer() const { return pointer_; }

 private:
  std::string code_;
  std::string pointer_;
};

struct Options {
  std::string base;  ///< IRI that relative references resolve against; empty: they stay relative
  /// Contexts that may be named by IRI; nothing is ever fetched.
  std::map<std::string, nlohmann::json> contexts;
  /// Taken in before the document's own context, as if it came first; null: none.
  nlohmann::json expand_context = nullptr;
  /// Keep, in every node and value object, where it came from: "@pointer": "/objects/3/geometry". Not JSON-LD; for
  /// error messages of the caller.
  bool keep_pointers = false;
  /// Reject keys that map to no IRI (JSON-LD drops them silently).
  bool reject_unknown_terms = false;
};

/// W3C JSON-LD 1.1 API, Expansion Algorithm (5.1.2). @throws JsonLdError.
OPAL_EXPORT nlohmann::json expand(const nlohmann::json& document, const Options& options = {});

/// W3C JSON-LD 1.1 API, Flattening (7.2) of the expanded document: an array of node objects by @id, without
/// compaction. @throws JsonLdError.
OPAL_EXPORT nlohmann::json flatten(const nlohmann::json& document, const Options& options = {});

}  // namespace opal::json_ld
