#include "synthetic.hpp"

#include "navigation/actions.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::navigation;

namespace {

/// A corridor along x between two equal rooms, which its half turn makes the other. Only the east room has a niche at
/// its far north corner, and it cannot be seen from the corridor's middle.
std::shared_ptr<const SemanticMap> two_rooms() {
  // clang-format off
  return map_of(room_of({{-10, -3}, {-4, -3}, {-4, -1}, {4, -1}, {4, -3}, {10, -3}, {10, 3}, {8, 3}, {8, 5}, {6, 5}, {6, 3},
                         {4, 3}, {4, 1}, {-4, 1}, {-4, 3}, {-10, 3}}));
  // clang-format on
}

}  // namespace

TEST_CASE("expected scans differ where the map does, and not where it repeats itself") {
  const MapView map(two_rooms(), "PlanarLidar2D");
  const LaserModel laser = wide_laser();
  const Pose2 half_turn(0, 0, std::numbers::pi);
  const auto apart = [&](const Pose2& pose) {
    return separation(expected_ranges(map, laser, pose, 12), expected_ranges(map, laser, half_turn * pose, 12));
  };
  CHECK(apart({0, 0, 0}) == 0);
  CHECK(apart({1, 0.3, 2}) < 0.2);
  CHECK(apart({7, 1, 1.5}) > 0.5);
}

TEST_CASE("the way leads to where two hypotheses would see different things") {
  const MapView map(two_rooms(), "PlanarLidar2D");
  const FloorGrid floor = mapped_floor(map, 0.25);
  const std::vector<PossiblePlace> places{{Pose2(2, 0, 0), 0.5}, {Pose2(-2, 0, std::numbers::pi), 0.5}};
  const auto viewpoint = best_viewpoint(map, wide_laser(), floor, {}, places, {});
  REQUIRE(viewpoint);
  CHECK(viewpoint->separation > 0.05);
  CHECK(viewpoint->path.back().x() > 3);  // the room ahead, and not the whole corridor back
  CHECK(viewpoint->path.back().x() < 10);
}

TEST_CASE("no way leads anywhere in a map that a half turn makes the same") {
  const MapView map(map_of(room_of({{0, 0}, {8, 0}, {8, 5}, {0, 5}})), "PlanarLidar2D");
  const FloorGrid floor = mapped_floor(map, 0.25);
  const std::vector<PossiblePlace> places{{Pose2(2, 2, 0), 0.5}, {Pose2(6, 3, std::numbers::pi), 0.5}};
  DisambiguateOptions options;
  options.least_separation = 0.4;  // a beam into a corner may miss both walls in one place and not in the other
  CHECK_FALSE(best_viewpoint(map, wide_laser(), floor, {}, places, {}, options));
}

TEST_CASE("the behaviour drives towards the asymmetry, whichever hypothesis is the right one") {
  SyntheticMoment moment(two_rooms(), {7, 0});
  const Pose2 half_turn(0, 0, std::numbers::pi);
  Pose2 truth = GENERATE(Pose2(2, 0, 0), Pose2(-2, 0, std::numbers::pi));
  const double from = std::abs(truth.x());
  Disambiguate disambiguate{{}};
  NodeStatus outcome = NodeStatus::running;
  for (int k = 0; k < 300 && outcome == NodeStatus::running; ++k) {
    const Pose2 best = truth.x() > 0 ? truth : half_turn * truth;  // always the east one
    moment.queries.stand(truth, {best, half_turn * best}, 0.1 * k);
    moment.blackboard.look();
    outcome = disambiguate.tick(moment.blackboard);
    truth = truth * moved(moment.blackboard.velocity(), 0.1);
  }
  CHECK(outcome == NodeStatus::success);
  CHECK(std::abs(truth.x()) > from + 0.5);
}

TEST_CASE("without alternatives there is nothing to tell apart") {
  SyntheticMoment moment(two_rooms(), {7, 0});
  moment.queries.stand({2, 0, 0}, {Pose2(2, 0, 0)}, 0);
  moment.blackboard.look();
  Disambiguate disambiguate{{}};
  CHECK(disambiguate.tick(moment.blackboard) == NodeStatus::failure);
}
