#pragma once

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <string>
#include <type_traits>

namespace opal::cli {

/// A check of a number. What is refused is told with what was expected.
/// @param expected  "from 0 to 1"
/// @param is_right  of one Number.
template <class Number, class IsRight>
CLI::Validator number_check(const std::string& expected, const std::string& description, IsRight is_right) {
  const auto complaint = [expected, is_right](std::string& text) {
    Number number{};
    const std::string noun = std::is_integral_v<Number> ? "a whole number " : "a number ";
    if (!CLI::detail::lexical_cast(text, number)) return fmt::format("'{}', expected {}{}", text, noun, expected);
    return is_right(number) ? std::string() : fmt::format("{} is not in range, expected {}{}", text, noun, expected);
  };
  return {complaint, description};
}

/// @param least  and `most`: of one type, which is how the range is told.
template <class Number>
CLI::Validator in_range(Number least, Number most) {
  const std::string range = fmt::format("{} to {}", least, most);
  return number_check<Number>("from " + range, range,
                              [least, most](Number number) { return number >= least && number <= most; });
}

inline CLI::Validator above_zero() {
  return number_check<double>("above 0", "above 0", [](double number) { return number > 0 && std::isfinite(number); });
}

inline CLI::Validator zero_or_more() {
  return number_check<double>("of 0 or more", "0 or more",
                              [](double number) { return number >= 0 && std::isfinite(number); });
}

/// A port behind a flag. A flag's value of 0 reads as "not", which is -1.
inline CLI::Validator port_of_flag() {
  return number_check<int>("from 0 to 65535", "0 to 65535", [](int port) { return port >= -1 && port <= 65535; });
}

/// A number with a default, which is refused outside its range.
/// @param least  and `most`: of one type, which is how the range is told.
template <class Number, class Bound>
void add_number(CLI::App& verb, const char* name, Number& value, Bound least, Bound most, const char* help) {
  verb.add_option(name, value, help)->check(in_range(least, most))->capture_default_str();
}

}  // namespace opal::cli
