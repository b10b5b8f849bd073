#pragma once

#include "localization/observation/plugin_failures.hpp"

#include <opal/localization/localizer.hpp>

namespace opal {

/// The same parts, but what templates and the scan matcher throw is counted as a failure of theirs: the template then
/// finds no pattern among the features that it was offered, and the match has not converged. Detectors and scorers are
/// guarded where they are called.
/// @param failures  must outlive the parts.
OPAL_EXPORT LocalizerParts guarded(LocalizerParts parts, PluginFailures& failures);

}  // namespace opal
