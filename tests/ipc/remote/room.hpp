#pragma once

#include "tests/kit/shipped_plugins.hpp"

#include "ipc/remote/localization_server.hpp"
#include "simulation/simulation.hpp"

#include <opal/deployment/deployment.hpp>

#include <memory>

/// A small room, and what localizes in it.
inline std::shared_ptr<const opal::SemanticMap> room() {
  static const auto map = opal::SemanticMap::read(OPAL_SOURCE_DIR "/maps/example_room.jsonld");
  return map;
}

inline opal::simulation::SimulationOptions world() {
  opal::simulation::SimulationOptions options;
  options.people = 1;
  options.robot_radius_m = 0.25;
  return options;
}

inline std::unique_ptr<opal::Localizer> localizer_of(const opal::LaserModel& laser) {
  opal::Deployment deployment = opal::read_deployment(OPAL_SOURCE_DIR "/configs/default.jsonld");
  const std::string sensor = deployment.lasers.front().id;
  deployment.lasers.front() = laser;
  deployment.lasers.front().id = sensor;
  return std::make_unique<opal::Localizer>(opal::build_parts(deployment, shipped_plugins(), room()));
}

inline std::unique_ptr<opal::remote::LocalizationServer> server(int port = 0) {
  return std::make_unique<opal::remote::LocalizationServer>(room(), opal::LaserModel().id, localizer_of, port);
}
