#pragma once

#include <opal/common/export.hpp>

#include <string>
#include <vector>

namespace opal::testing {

/// Puts one plugin file through everything that its users rely on: it loads, exports nothing but its door, is
/// what its description says, makes objects from its defaults and from the ends of its ranges, refuses wrong
/// options by name, and each of its types keeps the contract of its kind (detector_contract.hpp and the
/// others) with the scenes that come with the framework. For scenes of your own, call the contract of the
/// kind.
/// @return violations, one sentence each, for any test framework to print; empty for a good citizen.
OPAL_EXPORT std::vector<std::string> plugin_violations(const std::string& file);

/// Puts a class that takes the place of a plugin's type through the contract of its kind: a detector, a pattern
/// template or a scorer. It is made with its default options, by the plugins of the usual folders.
/// @param source  "acme_scorers.py:Likelihood". @return violations, likewise; also if it cannot be made.
OPAL_EXPORT std::vector<std::string> class_violations(const std::string& source);

}  // namespace opal::testing
