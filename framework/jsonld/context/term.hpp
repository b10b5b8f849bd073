#pragma once

#include "jsonld/context/context.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace opal::json_ld {

/// Null, "ltr" or "rtl". @throws JsonLdError for anything else.
std::optional<std::string> read_direction(const Json& value, const Place& place);

/// Create Term Definition (4.2.2) for the terms of one local context.
class TermReader {
 public:
  TermReader(ContextReader& contexts, ActiveContext& result, const Json& local, const Place& place,
             const ContextUse& use)
      : contexts_(contexts), result_(result), local_(local), place_(place), use_(use) {}

  /// Whether terms may be redefined that do not say so themselves.
  enum class Protection { none, all };
  void protect(Protection terms) { protection_ = terms; }
  /// Defines the term, after those that it depends on.
  void define(const std::string& term);

 private:
  using Definition = std::shared_ptr<const TermDefinition>;

  void define_from(const std::string& term, const Json& value, const Place& place);
  void check_keyword_term(const std::string& term, const Json& value, const Place& place) const;
  bool ignores(const std::string& text, const Place& place) const;
  std::optional<std::string> expand(const std::string& value);

  void read_use(TermDefinition& definition, const Json& map, const Place& place);
  void read_protected(TermDefinition& definition, const Json& value, const Place& place) const;
  void read_type(TermDefinition& definition, const Json& value, const Place& place);
  bool read_reverse(TermDefinition& definition, const Json& value, const Place& place);
  bool read_iri(TermDefinition& definition, const std::string& term, const Json& value, const Place& place);
  bool read_given_iri(TermDefinition& definition, const std::string& term, const Json& value, const Place& place);
  void derive_iri(TermDefinition& definition, const std::string& term, const Place& place);
  void check_iri_like_term(const std::string& term, const std::string& iri, const Place& place);
  void read_container(TermDefinition& definition, const Json& value, const Place& place);
  void read_index(TermDefinition& definition, const Json& value, const Place& place);
  void read_scoped(TermDefinition& definition, const Json& value, const Place& place);
  void read_language(TermDefinition& definition, const Json& value, const Place& place);
  void read_nest(TermDefinition& definition, const Json& value, const Place& place);
  void read_prefix(TermDefinition& definition, const std::string& term, const Json& value, const Place& place);
  void store(const std::string& term, TermDefinition definition, const Definition& before, const Place& place);

  ContextReader& contexts_;
  ActiveContext& result_;
  const Json& local_;
  const Place& place_;
  const ContextUse& use_;
  Protection protection_ = Protection::none;
  std::map<std::string, bool> defined_;  ///< false while the definition is being made
  int open_ = 0;                         ///< definitions that wait for one another
};

}  // namespace opal::json_ld
