#pragma once

#include "jsonld/context/context.hpp"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace opal::json_ld {

/// Inverse Context Creation (JSON-LD 1.1 API, 4.3): which term says an IRI, for values that are of some type or
/// language and stand in some container.
class InverseContext {
 public:
  explicit InverseContext(const ActiveContext& active);

  bool knows(const std::string& iri) const { return terms_.count(iri) > 0; }
  /// Term Selection (6.4).
  /// @param containers  "@list", "@index@set", ..., the preferred first.
  /// @param kind        "@type", "@language" or "@any"
  /// @param preferred   what may stand under the kind, the preferred first.
  /// @return nullptr if no term fits.
  const std::string* select(const std::string& iri, const std::vector<std::string_view>& containers,
                            std::string_view kind, const std::vector<std::string_view>& preferred) const;
  /// The shortest name with a prefix ("opal:Wall"), the first of several by alphabet; empty if no prefix fits.
  /// @param bare  nothing is known about a value: names that are terms themselves will do if they mean the IRI.
  std::string compact_name(const ActiveContext& active, const std::string& iri, bool bare) const;

 private:
  using TermOf = std::map<std::string, std::string, std::less<>>;  // "@null", "en_ltr", "@id" -> term
  using Kinds = std::map<std::string, TermOf, std::less<>>;
  using Containers = std::map<std::string, Kinds, std::less<>>;

  void add(const std::string& term, const TermDefinition& definition, const std::string& default_language);

  std::unordered_map<std::string, Containers> terms_;
  std::unordered_map<std::string, std::vector<std::string>> prefixes_;  // by IRI
  std::set<std::size_t> prefix_lengths_;
};

/// "en", "en_ltr", "_rtl"; "@null" if both are none.
std::string language_key(const std::optional<std::string>& language, const std::optional<std::string>& direction);

}  // namespace opal::json_ld
