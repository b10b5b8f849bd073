#pragma once

#include <opal/common/id.hpp>

#include <fmt/format.h>

/// fmt writes an id as its number.
template <class Kind>
struct fmt::formatter<opal::Id<Kind>> : fmt::formatter<int> {
  template <class Context>
  auto format(opal::Id<Kind> id, Context& context) const {
    return fmt::formatter<int>::format(id.number(), context);
  }
};
