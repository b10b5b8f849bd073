#pragma once

#include <opal/common/error.hpp>

#include <fmt/format.h>

namespace opal {

/// Refuses numbers that make no sense, in the words of who is told them.
class ExpectedNumbers {
 public:
  /// @param what  is told to do something, e.g. "cone mapping".
  constexpr explicit ExpectedNumbers(const char* what) : what_(what) {}

  /// @throws ConfigError if a number is not in [low, high].
  void operator()(const char* name, double found, double low, double high, const char* unit = "") const {
    if (!(found >= low && found <= high))
      throw ConfigError(
          fmt::format("{}: {} {:g}, expected {:g} to {:g}{}{}", what_, name, found, low, high, *unit ? " " : "", unit));
  }

 private:
  const char* what_;
};

}  // namespace opal
