// JSON-LD 1.1 API, 5.2.2: IRI Expansion.
#include "jsonld/context/context.hpp"
#include "jsonld/context/iri.hpp"

namespace opal::json_ld {
namespace {

/// Step 6: "prefix:suffix" and what looks like it.
std::optional<std::string> expand_compact(const ActiveContext& active, const std::string& value, std::size_t colon,
                                          const std::function<void(const std::string&)>& define) {
  const std::string prefix = value.substr(0, colon);
  if (prefix == "_" || value.compare(colon + 1, 2, "//") == 0) return value;
  if (define) define(prefix);
  const TermDefinition* definition = active.find(prefix);
  if (definition && definition->iri && definition->prefix) return *definition->iri + value.substr(colon + 1);
  if (is_absolute_iri(value)) return value;
  return {};
}

}  // namespace

std::optional<std::string> expand_iri(const ActiveContext& active, const std::string& value, IriUse use,
                                      const std::function<void(const std::string&)>& define) {
  if (is_keyword(value)) return value;
  if (has_keyword_form(value)) return {};
  if (define) define(value);
  const TermDefinition* definition = active.find(value);
  if (definition && definition->iri && is_keyword(*definition->iri)) return definition->iri;
  if (definition && use.vocabulary) return definition->iri;
  const std::size_t colon = value.find(':', 1);
  if (!value.empty() && colon != std::string::npos)
    if (auto iri = expand_compact(active, value, colon, define)) return iri;
  if (use.vocabulary && active.vocab) return *active.vocab + value;
  if (use.document_relative && active.base) return resolve_iri(*active.base, value);
  return value;
}

}  // namespace opal::json_ld
