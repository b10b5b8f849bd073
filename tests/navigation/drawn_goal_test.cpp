#include "closed_loop/drawn_goal.hpp"
#include "synthetic.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

std::shared_ptr<const SemanticMap> room() {
  return navigation::map_of(navigation::room_of({{0, 0}, {12, 0}, {12, 6}, {0, 6}}));
}

simulation::Simulation in_room() {
  simulation::SimulationOptions options;
  options.clutter.level = 0;
  options.people = 0;
  return {room(), options, 1};
}

}  // namespace

TEST_CASE("goals are drawn where a way leads, far from the start of a large room") {
  const unsigned seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  const simulation::Simulation simulation = in_room();
  const FloorGrid floor = navigation::mapped_floor(MapView(room(), "PlanarLidar2D"), 0.25);
  Random random(seed), again(seed);
  const auto goal = drawn_goal(simulation, floor, random);
  REQUIRE(goal);
  CHECK(floor.holds(*goal));
  CHECK((*goal - simulation.T_map_base().position()).norm() >= 3);
  CHECK(drawn_goal(simulation, floor, again) == goal);
}
