#pragma once

#include <opal/deployment.hpp>

#include <string>

namespace opal::experiments {

/// One way to localize that takes part in an experiment.
struct Contender {
  std::string name;  ///< of its configuration
  Deployment deployment;
  std::string behaviour;  ///< the tree by which it drives; only where it does
};

/// The deployment with the laser of a simulated robot in place of its own.
Deployment with_laser(Deployment deployment, const LaserModel& laser);

}  // namespace opal::experiments
