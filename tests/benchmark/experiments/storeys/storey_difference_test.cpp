#include "benchmark/experiments/storeys/storey_difference.hpp"

#include "map_tools/map_stack.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace opal;
using experiments::storey_difference;

namespace {

/// A room of 10 m by 8 m, and a wall in it that begins at (5, 0).
std::shared_ptr<const SemanticMap> room(double wall_m) {
  const std::vector<Point> corners{{0, 0}, {10, 0}, {10, 8}, {0, 8}};
  std::vector<Segment> faces;
  for (std::size_t k = 0; k < corners.size(); ++k) faces.push_back({corners[k], corners[(k + 1) % corners.size()]});
  if (wall_m > 0) {
    faces.push_back({{5, 0}, {5, wall_m}});
    faces.push_back({{5, wall_m}, {5, 0}});
  }
  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const std::string id = "wall-" + std::to_string(k);
    objects.push_back({id, "opal:Wall"});
    features.push_back({id + "/face", MapObjectNumber(static_cast<int>(k)), "opal:Wall", "PlanarLidar2D", faces[k]});
  }
  return SemanticMap::make("room", objects, features);
}

/// Storeys "0", "1", ... whose walls are so long.
MapView house(const std::vector<double>& walls_m) {
  std::vector<StoreyPart> parts;
  for (const double wall_m : walls_m) parts.push_back({std::to_string(parts.size()), "", {}, room(wall_m)});
  return MapView(stacked_map("house", parts).map, "PlanarLidar2D");
}

LaserModel all_around() {
  LaserModel laser;
  laser.angle_min_rad = -std::numbers::pi;
  laser.angle_increment_rad = std::numbers::pi / 180;
  laser.beams = 361;
  return laser;
}

/// A drive along y = 4, on a storey.
std::vector<Pose2> drive_on(const MapView& map, const std::string& storey) {
  std::vector<Pose2> poses;
  for (double x = 1; x < 9; x += 0.2) poses.push_back(find_storey(map.map(), storey)->to_map(Pose2({x, 4}, 0.3)));
  return poses;
}

}  // namespace

TEST_CASE("equal storeys differ in no beam, and a map of one storey has nothing to take it for") {
  const MapView twins = house({2, 2});
  CHECK(storey_difference(twins, drive_on(twins, "0"), all_around()) == 0);
  const MapView alone = house({2});
  CHECK(storey_difference(alone, drive_on(alone, "0"), all_around()) == 1);
  CHECK(storey_difference(twins, {}, all_around()) == 1);
}

TEST_CASE("the storey that is most like the one driven on counts, from whichever side one looks") {
  const MapView map = house({0, 1, 3});
  const double without = storey_difference(map, drive_on(map, "0"), all_around()),
               with_short = storey_difference(map, drive_on(map, "1"), all_around()),
               with_long = storey_difference(map, drive_on(map, "2"), all_around());
  CHECK(without > 0.01);
  CHECK(without == with_short);
  CHECK(with_long > 2 * without);
}

TEST_CASE("standing still tells no more than one look") {
  const MapView map = house({0, 3});
  const std::vector<Pose2> drive = drive_on(map, "0");
  std::vector<Pose2> with_stop = drive;
  with_stop.insert(with_stop.begin(), 50, drive.front());
  CHECK(storey_difference(map, with_stop, all_around()) == storey_difference(map, drive, all_around()));
}
