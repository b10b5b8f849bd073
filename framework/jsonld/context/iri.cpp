#include "jsonld/context/iri.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace opal::json_ld {
namespace {

using std::string_view;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_scheme_character(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.'; }

/// RFC 3986, appendix B.
struct IriParts {
  std::optional<string_view> scheme, authority, query, fragment;
  string_view path;
};

std::optional<string_view> take_scheme(string_view& rest) {
  const std::size_t colon = rest.find_first_of(":/?#");
  if (colon == string_view::npos || colon == 0 || rest[colon] != ':' || !is_letter(rest.front())) return {};
  const string_view scheme = rest.substr(0, colon);
  if (!std::all_of(scheme.begin(), scheme.end(), is_scheme_character)) return {};
  rest.remove_prefix(colon + 1);
  return scheme;
}

/// Cuts off what follows the first `mark`, the mark excluded.
std::optional<string_view> take_tail(string_view& rest, char mark) {
  const std::size_t at = rest.find(mark);
  if (at == string_view::npos) return {};
  const string_view tail = rest.substr(at + 1);
  rest = rest.substr(0, at);
  return tail;
}

IriParts split(string_view iri) {
  IriParts parts;
  parts.scheme = take_scheme(iri);
  parts.fragment = take_tail(iri, '#');
  parts.query = take_tail(iri, '?');
  if (iri.substr(0, 2) == "//") {
    const std::size_t end = std::min(iri.find('/', 2), iri.size());
    parts.authority = iri.substr(2, end - 2);
    iri.remove_prefix(end);
  }
  parts.path = iri;
  return parts;
}

/// RFC 3986, 5.2.4.
std::string remove_dot_segments(string_view path) {
  std::string result;
  const auto drop_last_segment = [&result] {
    const std::size_t slash = result.rfind('/');
    result.erase(slash == std::string::npos ? 0 : slash);
  };
  const auto starts = [&path](string_view with) { return path.substr(0, with.size()) == with; };
  while (!path.empty()) {
    if (starts("../"))
      path.remove_prefix(3);
    else if (starts("./") || starts("/./"))
      path.remove_prefix(2);
    else if (path == "/.")
      path = "/";
    else if (starts("/../"))
      path.remove_prefix(3), drop_last_segment();
    else if (path == "/..")
      path = "/", drop_last_segment();
    else if (path == "." || path == "..")
      path = {};
    else {
      const std::size_t end = std::min(path.find('/', 1), path.size());
      result += path.substr(0, end);
      path.remove_prefix(end);
    }
  }
  return result;
}

/// RFC 3986, 5.2.3.
std::string merge_paths(const IriParts& base, string_view reference) {
  if (base.authority && base.path.empty()) return '/' + std::string(reference);
  const std::size_t slash = base.path.rfind('/');
  return std::string(base.path.substr(0, slash == string_view::npos ? 0 : slash + 1)) + std::string(reference);
}

/// RFC 3986, 5.3.
std::string join(const IriParts& parts, string_view path) {
  std::string iri;
  if (parts.scheme) iri.append(*parts.scheme) += ':';
  if (parts.authority) iri.append("//").append(*parts.authority);
  iri += path;
  if (parts.query) (iri += '?').append(*parts.query);
  if (parts.fragment) (iri += '#').append(*parts.fragment);
  return iri;
}

}  // namespace

bool is_keyword(string_view text) {
  static constexpr std::array<string_view, 23> kKeywords{
      "@base",      "@container", "@context",  "@direction", "@graph", "@id",      "@import", "@included",
      "@index",     "@json",      "@language", "@list",      "@nest",  "@none",    "@prefix", "@propagate",
      "@protected", "@reverse",   "@set",      "@type",      "@value", "@version", "@vocab"};
  return std::find(kKeywords.begin(), kKeywords.end(), text) != kKeywords.end();
}

bool is_framing_keyword(string_view text) {
  static constexpr std::array<string_view, 5> kKeywords{"@default", "@embed", "@explicit", "@omitDefault",
                                                        "@requireAll"};
  return std::find(kKeywords.begin(), kKeywords.end(), text) != kKeywords.end();
}

bool has_keyword_form(string_view text) {
  return text.size() > 1 && text.front() == '@' && std::all_of(text.begin() + 1, text.end(), is_letter);
}

bool is_absolute_iri(string_view text) {
  return take_scheme(text) && text.find_first_of(" \t\r\n") == string_view::npos;
}

bool is_blank_node(string_view text) { return text.substr(0, 2) == "_:"; }

bool is_spelled_out(string_view iri) {
  const auto scheme = take_scheme(iri);
  return scheme && (iri.substr(0, 2) == "//" || *scheme == "urn" || *scheme == "tag");
}

bool ends_with_delimiter(string_view iri) {
  return !iri.empty() && string_view(":/?#[]@").find(iri.back()) != string_view::npos;
}

std::string resolve_iri(string_view base, string_view reference) {
  const IriParts from = split(base);
  IriParts to = split(reference);
  if (!from.scheme) return std::string(reference);
  if (to.scheme) return join(to, remove_dot_segments(to.path));
  to.scheme = from.scheme;
  if (to.authority) return join(to, remove_dot_segments(to.path));
  to.authority = from.authority;
  if (to.path.empty()) {
    if (!to.query) to.query = from.query;
    return join(to, from.path);
  }
  const bool rooted = to.path.front() == '/';
  return join(to, remove_dot_segments(rooted ? std::string(to.path) : merge_paths(from, to.path)));
}

namespace {

/// How many leading bytes of both paths are the same folders.
std::size_t common_folders(string_view a, string_view b) {
  std::size_t common = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()) && a[i] == b[i]; ++i)
    if (a[i] == '/') common = i + 1;
  return common;
}

}  // namespace

std::string relative_iri(string_view base, string_view iri) {
  const IriParts from = split(base), to = split(iri);
  const std::string whole(iri);
  if (!from.scheme || from.scheme != to.scheme || from.authority != to.authority) return whole;
  if (to.path.substr(0, 1) != "/" || from.path.substr(0, 1) != "/") return whole;
  std::string reference;
  if (to.path != from.path || (from.query && !to.query)) {
    const std::size_t common = common_folders(from.path, to.path);
    const string_view left = from.path.substr(common), rest = to.path.substr(common);
    for (const char c : left)
      if (c == '/') reference += "../";
    reference += rest;
    const bool hidden = reference.empty() || rest.substr(0, rest.find('/')).find(':') != string_view::npos;
    if (hidden && reference.size() == rest.size()) reference = "./" + reference;
  } else if (to.query == from.query) {
    return to.fragment ? "#" + std::string(*to.fragment) : std::string(to.path.substr(to.path.rfind('/') + 1));
  }
  if (to.query) (reference += '?').append(*to.query);
  if (to.fragment) (reference += '#').append(*to.fragment);
  return resolve_iri(base, reference) == iri ? reference : whole;
}

}  // namespace opal::json_ld
