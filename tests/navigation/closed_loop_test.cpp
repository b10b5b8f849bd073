#include "tests/kit/shipped_plugins.hpp"

#include "closed_loop/closed_loop.hpp"
#include "navigation/node_registry.hpp"

#include <opal/deployment/deployment.hpp>

#include <catch2/catch.hpp>

using namespace opal;

namespace {

const Point kGoal(1, 4);  // in the room: what is behind its door is not mapped

DriveRecord driven(const char* behaviour, std::uint64_t seed) {
  const auto map = SemanticMap::read(OPAL_SOURCE_DIR "/maps/example_room.jsonld");
  simulation::SimulationOptions world;
  world.people = 1;
  world.robot_radius_m = 0.25;
  Deployment deployment = read_deployment(OPAL_SOURCE_DIR "/configs/default.jsonld");
  deployment.lasers.front() = world.laser;
  const LocalizerParts parts = build_parts(deployment, shipped_plugins(), map);
  Localizer localizer(parts);
  simulation::Simulation simulation(map, world, seed);
  ClosedLoopOptions options;
  options.motion.radius_m = world.robot_radius_m;
  options.most_s = 300;
  const auto tree =
      navigation::read_tree(navigation::standard_nodes(), OPAL_SOURCE_DIR "/configs/behaviours.jsonld", behaviour);
  const Point goal = simulation.floor().nearest(kGoal).value();  // clutter may stand on the goal itself
  return drive_to_goal(simulation, localizer, navigation::mapped_floor(*parts.map, 0.2), *tree, goal, options);
}

}  // namespace

TEST_CASE("a robot that does not know where it is gets to its goal in a small room, and touches nothing") {
  const char* behaviour = GENERATE("disambiguate", "inspect");
  const std::uint64_t seed = GENERATE(1u, 2u);
  CAPTURE(behaviour, seed);
  const DriveRecord record = driven(behaviour, seed);
  CHECK(record.reached);
  CHECK(record.collisions.empty());
  CHECK(record.falsely_localized_scans == 0);
}

TEST_CASE("the same seed gives the same drive") {
  const DriveRecord a = driven("disambiguate", 2), b = driven("disambiguate", 2);
  CHECK(a.time_s == b.time_s);
  CHECK(a.driven_m == b.driven_m);
}
