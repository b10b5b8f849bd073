#include "patterns/sound_instance.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace opal {

void expect_sound(const PatternInstance& found, std::size_t offered) {
  if (found.members.size() != offered)
    throw PluginError(fmt::format("a pattern of {} members, expected {}", found.members.size(), offered));
  std::vector<bool> is_member(offered, false);
  for (const int member : found.members) {
    if (member < 0 || static_cast<std::size_t>(member) >= offered || is_member[static_cast<std::size_t>(member)])
      throw PluginError(fmt::format("a pattern with member {}, expected each of 0 to {} once", member, offered - 1));
    is_member[static_cast<std::size_t>(member)] = true;
  }
  for (const Invariant& invariant : found.invariants)
    if (!std::isfinite(invariant.value) || std::isnan(invariant.tolerance))
      throw PluginError(
          fmt::format("a pattern with the invariant {} +- {}, expected numbers", invariant.value, invariant.tolerance));
}

}  // namespace opal
