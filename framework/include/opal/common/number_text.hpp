#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace opal {

/// The number that a text is as a whole: without blanks, a plus sign or anything behind it. In every locale the same.
/// @tparam Number  what it has to fit into; a floating point number may be infinite or NaN.
/// @param text     for example "12" or "1.5e-3".
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  Number number{};
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  const auto [rest, error] = std::from_chars(begin, end, number);
  return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

}  // namespace opal
