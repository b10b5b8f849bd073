#include "plugins/score_beams/hit_chance.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <numbers>

using namespace opal;

namespace {

constexpr double kReach_m = 0.2;

/// A room of 20 m by 20 m; in its corner at (17, 17) so many slats, 2 m long and a hand's breadth apart.
MapView room_with_slats(int slats, const Pose2& T_map_room = {}) {
  std::vector<Segment> faces{{{0, 0}, {20, 0}}, {{20, 0}, {20, 20}}, {{20, 20}, {0, 20}}, {{0, 20}, {0, 0}}};
  for (int k = 0; k < slats; ++k) {
    const double y = 16 + 0.1 * k;
    faces.push_back({{16, y}, {18, y}});
    faces.push_back({{18, y + 0.03}, {16, y + 0.03}});
  }
  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const std::string id = "wall-" + std::to_string(k);
    objects.push_back({id, "opal:Wall"});
    features.push_back({id + "/face", MapObjectNumber(static_cast<int>(k)), "opal:Wall", "PlanarLidar2D",
                        transformed(T_map_room, Geometry(faces[k]))});
  }
  return MapView(SemanticMap::make("room", objects, features), "PlanarLidar2D");
}

}  // namespace

TEST_CASE("a hit is worth all it can between walls, and ever less the more is drawn around") {
  const Point among{17, 17}, at_wall{10, 0};
  double before = 1;
  for (const int slats : {0, 5, 10, 20}) {
    const HitChance chance(room_with_slats(slats), kReach_m);
    CAPTURE(slats);
    CHECK(chance.surprise(at_wall) == 1);
    CHECK(chance.surprise(among) > 0);
    CHECK(chance.surprise(among) <= before);
    before = chance.surprise(among);
  }
  CHECK(before < 0.5);
}

TEST_CASE("what a hit is worth moves with the map, but for the cells in which faces are counted") {
  const HitChance here(room_with_slats(20), kReach_m);
  const Pose2 T_map_room({1000.3, -400.7}, std::numbers::pi / 2);
  const HitChance there(room_with_slats(20, T_map_room), kReach_m);
  for (const Point& p : {Point(17, 17), Point(10, 0), Point(5, 5)})
    CHECK(std::abs(here.surprise(p) - there.surprise(T_map_room * p)) < 0.1);
}

TEST_CASE("points outside the map, none, and a map of columns alone are ordinary") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const HitChance chance(room_with_slats(3), kReach_m);
  for (const Point& p : {Point(-1e9, 1e9), Point(none, 0), Point(1e300, -1e300)}) {
    CHECK(chance.surprise(p) > 0);
    CHECK(chance.surprise(p) <= 1);
  }
  const auto column =
      SemanticMap::make("column", {{"c", "opal:Column"}},
                        {{"c/round", MapObjectNumber(0), "opal:Column", "PlanarLidar2D", Circle{{3, 4}, 0.2}}});
  CHECK(HitChance(MapView(column, "PlanarLidar2D"), kReach_m).surprise({3, 4}) == 1);
}
