#include "patterns/sound_instance.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

/// Each position from 0 on, in any order.
bool are_positions(const std::vector<int>& members) {
  for (int position = 0; position < static_cast<int>(members.size()); ++position)
    if (std::ranges::count(members, position) != 1) return false;
  return true;
}

}  // namespace

void expect_sound(const PatternInstance& found, std::size_t offered) {
  if (found.members.size() != offered || !are_positions(found.members))
    throw PluginError(fmt::format("a pattern with the members {}, expected each of {} features once",
                                  fmt::join(found.members, ", "), offered));
  for (const Invariant& invariant : found.invariants)
    if (!std::isfinite(invariant.value) || std::isnan(invariant.tolerance))
      throw PluginError(
          fmt::format("a pattern with the invariant {} +- {}, expected numbers", invariant.value, invariant.tolerance));
}

}  // namespace opal
