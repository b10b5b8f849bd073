#pragma once

#include <opal/deployment/deployment.hpp>

#include <string>

namespace opal::experiments {

/// One way to localize that takes part in an experiment.
struct Contender {
  std::string name;  ///< of its configuration
  Deployment deployment;
  std::string behaviour;  ///< the tree by which it drives; only where it does
};

}  // namespace opal::experiments
