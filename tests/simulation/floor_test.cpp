#include "simulation/simulation.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::simulation;

namespace {

/// Walls, each a solid box, and doors, each a leaf that no sensor perceives.
class Plan {
 public:
  Plan& wall(const Point& low, const Point& high) {
    objects_.push_back({"wall-" + std::to_string(objects_.size()), "opal:Wall"});
    const Point corners[] = {low, {low.x(), high.y()}, high, {high.x(), low.y()}};
    for (int k = 0; k < 4; ++k) add("opal:Wall", "PlanarLidar2D", {corners[k], corners[(k + 1) % 4]});
    return *this;
  }
  Plan& door(const Segment& leaf) {
    objects_.push_back({"door-" + std::to_string(objects_.size()), "opal:Door"});
    add("opal:Door", "", leaf);
    return *this;
  }
  Plan& face(const Segment& seen_from_its_left) {
    objects_.push_back({"wall-" + std::to_string(objects_.size()), "opal:Wall"});
    add("opal:Wall", "PlanarLidar2D", seen_from_its_left);
    return *this;
  }
  std::shared_ptr<const SemanticMap> map() const { return SemanticMap::make("plan", objects_, features_); }

 private:
  void add(const char* type, const char* sensor, const Segment& face) {
    const MapObjectNumber object(objects_.size() - 1);
    features_.push_back({"face-" + std::to_string(features_.size()), object, type, sensor, face});
  }
  std::vector<MapObject> objects_;
  std::vector<MapFeature> features_;
};

/// Two rooms with a door of 1 m between them, and an outer door in the right wall of the second.
Plan two_rooms() {
  Plan plan;
  plan.wall({-0.2, -0.2}, {12.4, 0}).wall({-0.2, 5}, {12.4, 5.2}).wall({-0.2, 0}, {0, 5});
  plan.wall({6, 0}, {6.2, 2}).wall({6, 3}, {6.2, 5}).door({{6.1, 2}, {6.1, 3}});
  plan.wall({12.2, 0}, {12.4, 2}).wall({12.2, 3.2}, {12.4, 5}).door({{12.3, 2}, {12.3, 3.2}});
  return plan;
}

SimulationOptions empty_world(double doors_open_share) {
  SimulationOptions options;
  options.clutter.level = 0;
  options.people = 0;
  options.doors_open_share = doors_open_share;
  return options;
}

const Point kFirst(1, 1), kSecond(11, 4), kBefore(13, 2.6);  ///< before the outer door

}  // namespace

TEST_CASE(
    "a corridor around a block is floor, and what the block's walls enclose is none, though a piece of them is "
    "missing") {
  Plan plan;
  plan.wall({-0.2, -0.2}, {14.2, 0}).wall({-0.2, 14}, {14.2, 14.2}).wall({-0.2, 0}, {0, 14}).wall({14, 0}, {14.2, 14});
  plan.face({{1.5, 1.5}, {1.5, 12.5}}).face({{1.5, 12.5}, {12.5, 12.5}}).face({{12.5, 1.5}, {1.5, 1.5}});
  plan.face({{12.5, 12.5}, {12.5, 8}}).face({{12.5, 6.8}, {12.5, 1.5}});
  const Simulation simulation(plan.map(), empty_world(1), 1);
  CHECK(simulation.floor().holds({1, 0.75}, {13, 0.75}));
  CHECK(simulation.floor().holds({13.25, 1}, {13.25, 13}));
  for (const Point& inside : {Point(7, 7), Point(3, 3), Point(3, 11), Point(11, 11)}) {
    CAPTURE(inside.transpose());
    CHECK_FALSE(simulation.floor().holds(inside));
  }
}

TEST_CASE("an open door is floor that leads into the next room, a shut one is not") {
  const std::uint64_t seed = GENERATE(range(1, 7));
  CAPTURE(seed);
  const Simulation open(two_rooms().map(), empty_world(1), seed), shut(two_rooms().map(), empty_world(0), seed);
  CHECK(open.floor().way(kFirst, kSecond));
  CHECK_FALSE(shut.floor().way(kFirst, kSecond));
}

TEST_CASE("open leaves stand in the rooms and leave the corridor free") {
  Plan plan;
  plan.wall({-0.2, -0.2}, {8.2, 0}).wall({-0.2, 5.2}, {8.2, 5.4}).wall({-0.2, 0}, {0, 5.2}).wall({8, 0}, {8.2, 5.2});
  plan.wall({0, 3}, {3, 3.2}).wall({4.2, 3}, {8, 3.2}).door({{3, 3.1}, {4.2, 3.1}});  // a corridor of 1.5 m below
  plan.wall({0, 1.3}, {8, 1.5});
  const std::uint64_t seed = GENERATE(range(1, 9));
  CAPTURE(seed);
  const Simulation simulation(plan.map(), empty_world(1), seed);
  CHECK(simulation.floor().holds({1, 2.25}, {7, 2.25}));
  CHECK(simulation.floor().way({1, 2.25}, {1, 4.2}));
}

TEST_CASE("an outer door stays shut, and nobody is outdoors, unless robots may be there") {
  SimulationOptions options = empty_world(1);
  const Simulation inside(two_rooms().map(), options, 3);
  CHECK(inside.floor().holds(kSecond));
  for (const int cell : inside.floor().cells()) {
    const Point p = inside.floor().center_of(cell);
    CHECK((p.x() > 0 && p.x() < 12.2 && p.y() > 0 && p.y() < 5));
  }
  options.outdoors = true;
  const Simulation anywhere(two_rooms().map(), options, 3);
  CHECK(anywhere.floor().way(kSecond, kBefore));
}

TEST_CASE("what stands along walls hides most of them, leaves doors free, and a way to every room") {
  const std::uint64_t seed = GENERATE(range(1, 7));
  CAPTURE(seed);
  SimulationOptions furnished = empty_world(1);
  furnished.clutter.along_walls = 0.9;
  const Simulation simulation(two_rooms().map(), furnished, seed);
  CHECK(simulation.floor().way({3, 2.5}, {9, 2.5}));
  double hidden_m = 0;
  for (double x = 0.3; x < 5.8; x += 0.1) {  // the lower wall of the first room, seen from its middle line
    const RayHit hit = simulation.solids().cast({x, 2.5}, {0, -1}, 10);
    hidden_m += hit.range_m < 2.4 ? 0.1 : 0;
  }
  CHECK(hidden_m > 2);
}

TEST_CASE("a robot among columns without walls stays between them") {
  Plan columns;
  for (const double x : {0, 5, 10})
    for (const double y : {0, 5}) columns.wall({x, y}, {x + 0.3, y + 0.3});
  const Simulation simulation(columns.map(), empty_world(1), 1);
  CHECK(simulation.floor().holds({2.5, 2.5}));
  for (const int cell : simulation.floor().cells()) {
    const Point p = simulation.floor().center_of(cell);
    CHECK((p.x() > 0 && p.x() < 10.3 && p.y() > 0 && p.y() < 5.3));
  }
}
