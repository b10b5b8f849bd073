#pragma once

#include "jsonld/context/place.hpp"

#include "jsonld/json_ld.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace opal::json_ld {

using Json = nlohmann::json;

/// A language or base direction: not said at all, said to be none, or a value.
using Inherited = std::optional<std::optional<std::string>>;

/// A context that a term definition carries: it holds for the term's values, or for nodes of that type.
struct ScopedContext {
  Json context;
  std::string base;      ///< IRI of the document that it stands in
  std::string document;  ///< prefix of its pointers
};

/// JSON-LD 1.1 API, 4.2: what a term means.
struct TermDefinition {
  std::optional<std::string> iri;  ///< nullopt: mapped to null, so ignored on purpose
  bool prefix = false;
  bool is_protected = false;
  bool reverse = false;
  std::optional<std::string> type;
  Inherited language;
  Inherited direction;
  std::set<std::string, std::less<>> container;
  std::optional<std::string> index;
  std::optional<std::string> nest;
  std::shared_ptr<const ScopedContext> scoped;

  bool contains(std::string_view keyword) const { return container.find(keyword) != container.end(); }
};
bool same_meaning(const TermDefinition& a, const TermDefinition& b);  ///< whether protected or not

/// JSON-LD 1.1 API, 4.1: what the terms of a document mean at some place in it. Immutable once made, shared
/// by all places that it holds for.
struct ActiveContext {
  std::optional<std::string> base;
  std::string original_base;
  std::optional<std::string> vocab, language, direction;
  std::map<std::string, std::shared_ptr<const TermDefinition>, std::less<>> terms;
  std::shared_ptr<const ActiveContext> previous;  ///< to go back to in the nodes below

  const TermDefinition* find(std::string_view term) const;
};
using ContextPtr = std::shared_ptr<const ActiveContext>;

struct IriUse {
  bool vocabulary = false;         ///< terms and @vocab count
  bool document_relative = false;  ///< the base IRI counts
};
/// IRI Expansion (5.2.2). @return nullopt for what maps to null.
/// @param define  called with each term that the result depends on, while a local context is being read.
std::optional<std::string> expand_iri(const ActiveContext& active, const std::string& value, IriUse use,
                                      const std::function<void(const std::string&)>& define = {});

/// How a local context is taken in.
struct ContextUse {
  std::string base;  ///< IRI that context references resolve against
  bool override_protected = false;
  bool propagate = true;
  bool validate_scoped = true;
  std::vector<std::string> remote;  ///< contexts by IRI that led here, outermost first
};

/// Context Processing (4.1.2).
class ContextReader {
 public:
  explicit ContextReader(const Options& options) : options_(options) {}

  ContextPtr initial() const;
  ContextPtr read(const ContextPtr& active, const Json& local, const Place& place, const ContextUse& use);
  /// The active context with the definition's scoped context on top.
  ContextPtr read_scoped(const ContextPtr& active, const TermDefinition& definition, const Place& place,
                         bool type_scoped);
  const Options& options() const { return options_; }

 private:
  using Building = std::shared_ptr<ActiveContext>;

  Building clear(const Building& current, const Place& place, const ContextUse& use) const;
  Building take(const Building& current, const Json& context, const Place& place, const ContextUse& use);
  Building read_remote(const Building& current, const std::string& reference, const Place& place,
                       const ContextUse& use);
  void read_map(ActiveContext& result, const Json& local, const Place& place, const ContextUse& use);
  Json with_import(const Json& local, const Place& place, const ContextUse& use);
  const Json& load(const std::string& iri, const Place& place);
  void define_terms(ActiveContext& result, const Json& local, const Place& place, const ContextUse& use);

  struct ScopedResult {
    ContextPtr active, result;
    std::shared_ptr<const ScopedContext> scoped;  // held, so that nothing else can take its address
  };
  using ScopedKey = std::tuple<const ActiveContext*, const ScopedContext*, bool>;

  const Options& options_;
  int loads_ = 0;  ///< contexts loaded since the outermost read began
  int open_ = 0;   ///< reads inside each other
  std::map<ScopedKey, ScopedResult> scoped_results_;
};

}  // namespace opal::json_ld
