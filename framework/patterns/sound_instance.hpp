#pragma once

#include <opal/common/export.hpp>
#include <opal/patterns/pattern.hpp>

#include <cstddef>

namespace opal {

/// @param offered  features that the template was given.
/// @throws PluginError if the members that it gives are not these, each once, or an invariant is no number.
OPAL_EXPORT void expect_sound(const PatternInstance& found, std::size_t offered);

}  // namespace opal
