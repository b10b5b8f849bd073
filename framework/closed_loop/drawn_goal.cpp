#include "closed_loop/drawn_goal.hpp"

#include <cmath>

namespace opal {

std::optional<Point> drawn_goal(const simulation::Simulation& simulation, const FloorGrid& floor, Random& random) {
  constexpr double kLarge_m2 = 40, kLeast_m = 3;
  constexpr int kMostDraws = 100000;
  const Point start = simulation.T_map_base().position();
  const bool is_large = simulation.floor().area_m2() > kLarge_m2;
  const auto ways = floor.ways(start);
  for (int draw = 0; draw < kMostDraws; ++draw) {
    const Point goal = simulation.floor().anywhere(random);
    const bool is_far = !is_large || (goal - start).norm() >= kLeast_m;
    const int cell = floor.cell_at(goal);
    if (is_far && ways && cell >= 0 && std::isfinite(ways->cost[cell])) return goal;
  }
  return std::nullopt;
}

}  // namespace opal
