#pragma once

#include <string>
#include <string_view>

namespace opal::json_ld {

/// A keyword of JSON-LD 1.1 (section 1.7), framing keywords excluded.
bool is_keyword(std::string_view text);
/// A keyword that has a meaning in frames only (JSON-LD 1.1 Framing, 1.3).
bool is_framing_keyword(std::string_view text);
/// "@" followed by letters only: reserved for keywords to come, and ignored by the algorithms until then.
bool has_keyword_form(std::string_view text);
/// Scheme, colon, no blanks. Blank node identifiers do not count.
bool is_absolute_iri(std::string_view text);
bool is_blank_node(std::string_view text);
/// Names its authority ("https://example.org/a") or has a scheme made for names: urn (RFC 8141), tag (RFC
/// 4151). Whatever else looks like "a:b" may as well be a compact IRI whose prefix nobody defined.
bool is_spelled_out(std::string_view iri);
/// Ends with a character that may separate a prefix from a suffix (RFC 3986, gen-delims).
bool ends_with_delimiter(std::string_view iri);

/// The shortest reference that resolves to the IRI from the base; the IRI itself if there is none.
std::string relative_iri(std::string_view base, std::string_view iri);

/// RFC 3986, 5.2: the reference resolved against the base; unchanged if the base is not absolute.
std::string resolve_iri(std::string_view base, std::string_view reference);

}  // namespace opal::json_ld
