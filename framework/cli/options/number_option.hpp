#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// A number with a default, which is refused outside its range.
/// @param least  and `most`: of one type, which is how the range is told.
template <class Number, class Bound>
void add_number(CLI::App& verb, const char* name, Number& value, Bound least, Bound most, const char* help) {
  verb.add_option(name, value, help)->check(CLI::Range(least, most))->capture_default_str();
}

}  // namespace opal::cli
