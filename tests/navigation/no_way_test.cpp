#include "closed_loop/no_way.hpp"
#include "synthetic.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

/// Two rooms of 5 m x 5 m seen from both sides, the second one behind a door of that width.
std::shared_ptr<const SemanticMap> two_rooms(double door_m) {
  const double low = 2.5 - door_m / 2, high = 2.5 + door_m / 2;
  // clang-format off
  std::vector<Segment> faces = navigation::room_of({{0, 0}, {5, 0}, {5, low}, {5.2, low}, {5.2, 0}, {10, 0}, {10, 5},
                                                    {5.2, 5}, {5.2, high}, {5, high}, {5, 5}, {0, 5}});
  // clang-format on
  for (const Segment& outer : navigation::room_of({{-0.2, -0.2}, {-0.2, 5.2}, {10.2, 5.2}, {10.2, -0.2}}))
    faces.push_back(outer);
  std::vector<MapObject> objects{{"wall", "opal:Wall"}, {"D7", "opal:Door"}};
  std::vector<MapFeature> features;
  for (const Segment& face : faces)
    features.push_back(
        {"face-" + std::to_string(features.size()), MapObjectNumber(0), "opal:Wall", "PlanarLidar2D", face});
  features.push_back({"leaf", MapObjectNumber(1), "opal:Door", "", Segment{{5.1, low}, {5.1, high}}});
  return SemanticMap::make("two rooms", std::move(objects), std::move(features));
}

simulation::Simulation world_of(double door_m, double doors_open_share) {
  simulation::SimulationOptions options;
  options.clutter.level = 0;
  options.people = 0;
  options.doors_open_share = doors_open_share;
  return {two_rooms(door_m), options, 1};
}

/// One of two places, of which one is cut off.
std::string why_cut_off(const simulation::Simulation& simulation) {
  return why_not_at(simulation, {1, 1}) + why_not_at(simulation, {9, 1});
}

}  // namespace

TEST_CASE("what keeps a robot from a place is told in words") {
  CHECK(why_cut_off(world_of(1.2, 1)).empty());
  CHECK_THAT(why_cut_off(world_of(0.6, 1)),
             Catch::Contains("the door 'D7', 0.60 m wide, is narrower than the robot") && Catch::Contains("0.80 m"));
  CHECK_THAT(why_cut_off(world_of(1.2, 0)), Catch::Contains("the door 'D7' is shut (--doors-open 1 opens all)"));
  const auto world = world_of(1.2, 1);
  CHECK_THAT(why_not_at(world, {2.5, 0.2}),
             Catch::Contains("the wall 'wall' is 0.20 m away") && Catch::Contains("0.40 m"));
  CHECK_THAT(why_not_at(world, {10.19, 2}), Catch::Contains("the robot needs") || Catch::Contains("outdoors"));
  CHECK_THAT(why_not_at(world, {50, 2}), Catch::Contains("beyond the building"));
}
