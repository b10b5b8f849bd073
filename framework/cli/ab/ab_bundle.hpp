#pragma once

#include "cli/ab/ab_session.hpp"

namespace opal::cli {

/// `opal ab bundle`: puts a finished experiment into one folder. @return exit code.
int bundle_experiment(const AbOptions& options);

/// `opal ab repeat`: computes a bundle's experiment, says how the verdict differs. @return exit code; 1 if it differs.
int repeat_bundle(const AbOptions& options);

}  // namespace opal::cli
