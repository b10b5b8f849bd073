#include "experiments/contender.hpp"

namespace opal::experiments {

Deployment with_laser(Deployment deployment, const LaserModel& laser) {
  const std::string sensor = deployment.laser.id;
  deployment.laser = laser;
  deployment.laser.id = sensor;
  return deployment;
}

}  // namespace opal::experiments
