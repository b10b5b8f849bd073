#include "localization/decision/ride_watch.hpp"

#include "map_tools/map_stack.hpp"

#include <opal/plugin/testing/scorer_contract.hpp>

#include <catch2/catch.hpp>

using namespace opal;

namespace {

/// Three storeys and a lift at (2, 2) of each; that of "c" is drawn turned by a quarter.
std::shared_ptr<const MapView> house() {
  const auto map = testing::example_map();
  const std::vector<StoreyPart> parts{{"a", "", {}, map}, {"b", "", {}, map}, {"c", "", {}, map}};
  const auto stacked = stacked_map("house", parts).map;
  MapOrigin origin = stacked->origin();
  const double quarter_rad = std::numbers::pi / 2;
  origin.connections = {{"lift", "opal:Lift", "", 1, {{"a", {2, 2, 0}}, {"b", {2, 2, 0}}, {"c", {3, 1, quarter_rad}}}}};
  return std::make_shared<MapView>(
      SemanticMap::make("house", stacked->objects(), stacked->features(), {}, std::move(origin)), "PlanarLidar2D");
}

Pose2 on(const MapView& map, const std::string& storey, const Pose2& T_storey_base) {
  return find_storey(map.map(), storey)->to_map(T_storey_base);
}

struct Rider {
  bool stands(double seconds, bool sees_other = false) {
    bool told = false;
    for (const double end_s = now_s + seconds; now_s < end_s;) {
      now_s += 0.1;
      told |= watch.may_have_ridden(sample(), best, sees_other);
    }
    return told;
  }
  Sample sample() const {
    Sample sample;
    sample.stamp_s = now_s;
    sample.T_odom_base = T_odom_base;
    return sample;
  }
  std::shared_ptr<const MapView> map = house();
  RideWatch watch{map, {.stand_s = 5}};
  std::optional<Pose2> best = on(*map, "a", {2.2, 2, 0.5});
  Pose2 T_odom_base;
  double now_s = 0;
};

}  // namespace

TEST_CASE("a robot that stands in a lift for long enough may have been carried, and that is said once") {
  Rider robot;
  CHECK_FALSE(robot.stands(4));
  CHECK(robot.stands(2));
  CHECK_FALSE(robot.stands(60));
  robot.T_odom_base = Pose2(0.2, 0, 0);
  CHECK_FALSE(robot.stands(4));
  CHECK(robot.stands(2));
}

TEST_CASE("a robot in a lift that sees something else all at once may be carried from then on") {
  Rider robot;
  CHECK_FALSE(robot.stands(2));
  CHECK(robot.stands(0.2, true));
  CHECK_FALSE(robot.stands(20, true));
  Rider outside;
  outside.best = on(*outside.map, "a", {4, 2, 0});
  CHECK_FALSE(outside.stands(20, true));
}

TEST_CASE("a robot that stands elsewhere, that knows no place, or that moves, is not carried") {
  Rider robot;
  robot.best = on(*robot.map, "a", {4, 2, 0});
  CHECK_FALSE(robot.stands(20));
  robot.best.reset();
  CHECK_FALSE(robot.stands(20));
  Rider moving;
  for (int k = 0; k < 20; ++k) {
    moving.T_odom_base = Pose2(0.1 * k, 0, 0);
    CHECK_FALSE(moving.stands(1));
  }
}

TEST_CASE("a robot in a lift may be at the same place of the cabin on every other storey, turned as they are drawn") {
  const Rider robot;
  const std::vector<Pose2> elsewhere = robot.watch.elsewhere(on(*robot.map, "a", {2.5, 2, 0.1}));
  REQUIRE(elsewhere.size() == 2);
  CHECK(distance_m(elsewhere[0], on(*robot.map, "b", {2.5, 2, 0.1})) < 1e-9);
  const Pose2 turned = on(*robot.map, "c", {3, 1.5, 0.1 + std::numbers::pi / 2});
  CHECK(distance_m(elsewhere[1], turned) < 1e-9);
  CHECK(angle_between_rad(elsewhere[1], turned) < 1e-9);
  CHECK(robot.watch.elsewhere(on(*robot.map, "a", {3.2, 2, 0})).empty());
}

TEST_CASE("a lift that stops at one storey carries nobody") {
  const auto map = house();
  MapOrigin origin = map->map().origin();
  origin.connections.front().landings.resize(1);
  const auto one_stop = std::make_shared<MapView>(
      SemanticMap::make("house", map->map().objects(), map->map().features(), {}, std::move(origin)), "PlanarLidar2D");
  Rider robot;
  robot.watch = RideWatch(one_stop, {.stand_s = 5});
  CHECK_FALSE(robot.stands(60));
  CHECK(robot.watch.elsewhere(*robot.best).empty());
}
