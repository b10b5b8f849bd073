#pragma once

#include <opal/common/export.hpp>
#include <opal/localization/options/localizer_options.hpp>

namespace opal {

/// What a deployment prefers where the evidence is thin. docs/results.md has what each costs.
enum class Caution {
  usual,    ///< the best known options: most places are called localized, and soon
  careful,  ///< fewer wrong poses are called localized; right ones later, and some never
  strict    ///< careful, and only on a map that shows the building as it is
};

/// The options of all stages that a deployment begins with.
OPAL_EXPORT LocalizerOptions options_of(Caution caution);

}  // namespace opal
