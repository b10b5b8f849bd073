#pragma once

#include "cli/options/number_option.hpp"
#include "session/session.hpp"

#include "simulation/simulation.hpp"

#include <CLI/CLI.hpp>

namespace opal::cli {

/// The options of every verb that simulates: what is in the building, and how the robot moves.
struct WorldOptions {
  simulation::SimulationOptions world;
  std::string furnished;

  /// Reads what is to be read, when the building is known.
  void furnish(const PluginRegistry& registry, const SemanticMap& building) {
    if (!furnished.empty())
      world.furniture = simulation::furniture_solids(*session::load_map(registry, furnished), building);
  }

  /// The lasers that a deployment describes; the simulator's, if it describes none or leaves it to the log.
  void take_laser(const Deployment& deployment) {
    if (deployment.describes_laser && !deployment.lasers.front().geometry_from_log) world.take(deployment.lasers);
    world.laser.id = deployment.lasers.front().id;
  }

  void add_to(CLI::App& verb) {
    add_number(verb, "--clutter", world.clutter.level, 0.0, 100.0,
               "how much stands about that the map does not hold; 1: everyday, 0: nothing");
    add_number(verb, "--lookalikes", world.clutter.lookalikes, 0.0, 100.0,
               "round things like the building's columns, per 100 m2, times --clutter");
    add_number(verb, "--hidden", world.clutter.hidden_share, 0.0, 1.0, "share of columns and corners behind a board");
    add_number(verb, "--along-walls", world.clutter.along_walls, 0.0, simulation::kMostAlongWalls,
               "share of the walls that stand behind machines, boxes, benches and bins");
    verb.add_option("--furniture", furnished,
                    "another map of the building: what only that one holds stands there, too");
    add_number(verb, "--people", world.people, 0.0, 1000.0, "who walk about");
    add_number(verb, "--doors-open", world.doors_open_share, 0.0, 1.0, "share of doors that are open");
    add_number(verb, "--robot-radius", world.robot_radius_m, 0.01, 10.0, "[m]");
    verb.add_flag("--outdoors", world.outdoors, "robots can be outdoors, too, and outer doors may be open");
    verb.add_flag_callback(
        "--omnidirectional", [this] { world.drive = simulation::Drive::omnidirectional; },
        "mecanum wheels instead of two wheels");
  }
};

}  // namespace opal::cli
