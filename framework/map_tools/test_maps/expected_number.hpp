#pragma once

#include <opal/common/error.hpp>

#include <fmt/format.h>

namespace opal {

/// @param what  is told to do something, e.g. "cone mapping". @throws ConfigError if a number is not in [low, high].
inline void expect_between(const char* what, const char* name, double found, double low, double high,
                           const char* unit = "") {
  if (!(found >= low && found <= high))
    throw ConfigError(
        fmt::format("{}: {} {:g}, expected {:g} to {:g}{}{}", what, name, found, low, high, *unit ? " " : "", unit));
}

}  // namespace opal
