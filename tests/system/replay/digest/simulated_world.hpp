#pragma once

#include "simulation/buildings/building.hpp"
#include "simulation/drives/faults.hpp"
#include "simulation/drives/recording.hpp"
#include "tests/kit/shipped_plugins.hpp"

#include <opal/deployment/deployment.hpp>

#include <string>
#include <utility>
#include <vector>

using Arrivals = std::vector<opal::simulation::Arrival>;
using Faults = std::vector<std::pair<opal::simulation::Fault, opal::simulation::FaultWindow>>;

/// What a robot drives through, and what it is told.
struct World {
  std::shared_ptr<const opal::SemanticMap> map;
  std::string config = "two_lasers.jsonld";
  opal::simulation::SimulationOptions options;

  opal::Deployment deployment() const { return opal::read_deployment(OPAL_SOURCE_DIR "/configs/" + config); }
  opal::LocalizerParts parts() const { return opal::build_parts(deployment(), shipped_plugins(), map); }
};

/// A generated building in which somebody walks.
World world_of(const opal::simulation::BuildingRequest& building, const std::string& config = "two_lasers.jsonld");
/// A drive to places all over the floor.
opal::simulation::Recording driven(const World& world, double duration_s, std::uint64_t seed);
/// To a millimetre and to 0.1 mrad, as logs are written: what processors round otherwise is the same then.
Arrivals arrivals_in(const opal::simulation::Recording& recording);
/// Of such a drive, with what goes wrong with its records.
Arrivals arrivals_with(const World& world, double duration_s, const Faults& faults);
