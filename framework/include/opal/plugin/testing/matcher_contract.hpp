#pragma once

#include <opal/local_map/scan_matcher.hpp>
#include <opal/plugin/registrar.hpp>

#include <string>
#include <vector>

namespace opal::testing {

/// What every scan matcher promises (scan_matcher.hpp): nothing thrown for poor data, which does not
/// converge; finite results; the same answer twice and from two threads; a scan of a room laid over itself
/// from a guess that is 5 cm and 0.03 rad off comes back to within 2 cm and 0.01 rad wherever it says that it
/// has converged, and it says so at least once.
/// @return violations, one sentence each; empty for a good citizen.
OPAL_EXPORT std::vector<std::string> matcher_violations(const ScanMatcher& matcher, const TypeInfo& type);

}  // namespace opal::testing
