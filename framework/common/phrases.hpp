#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <concepts>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace opal {

// Parts of sentences.

inline std::string in_quotes(std::string_view text) { return fmt::format("'{}'", text); }

/// "3 things", "1 thing"
inline std::string count_of(std::integral auto count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

/// "a, b, c"; beyond `most`: "a, b and 4 more". @param none  said if there is nothing.
template <class Texts>
std::string listed(const Texts& texts, std::string_view none = "", std::size_t most = std::string::npos) {
  const std::size_t count = std::size(texts), shown = std::min(most, count);
  if (count == 0) return std::string(none);
  const auto end = std::next(std::begin(texts), static_cast<std::ptrdiff_t>(shown));
  return fmt::format("{}{}", fmt::join(std::begin(texts), end, ", "),
                     shown < count ? fmt::format(" and {} more", count - shown) : "");
}

/// listed() of the text of each thing. @param text_of  a member or a function of one thing.
template <class Things, class TextOf>
std::string listed_by(const Things& things, TextOf text_of) {
  std::vector<std::string> texts;
  for (const auto& thing : things) texts.emplace_back(std::invoke(text_of, thing));
  return listed(texts);
}

}  // namespace opal
