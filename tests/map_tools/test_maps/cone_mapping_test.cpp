#include "map_tools/test_maps/cone_mapping.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace opal;

namespace {

/// A laser that sees all around, in a room of 8 x 6 m about the origin.
Scan scan_of_room(const Pose2& T_map_laser) {
  Scan scan;
  scan.range_max_m = 30;
  scan.angle_increment_rad = std::numbers::pi / 180;
  for (int beam = 0; beam < 360; ++beam) {
    const double bearing = -std::numbers::pi + beam * scan.angle_increment_rad;
    const Point way = T_map_laser.rotate(unit_vector(bearing));
    const double to_x = ((way.x() > 0 ? 4 : -4) - T_map_laser.x()) / way.x();
    const double to_y = ((way.y() > 0 ? 3 : -3) - T_map_laser.y()) / way.y();
    const double range = std::min(to_x, to_y);
    scan.points.push_back({range * unit_vector(bearing), range, bearing, beam});
  }
  return scan;
}

std::vector<PlacedScan> drive() {
  std::vector<PlacedScan> scans;
  for (int k = 0; k < 60; ++k) {
    const Pose2 at(-2.5 + 5.0 * k / 60, std::sin(k / 9.0), 0.3 * k);
    scans.push_back({scan_of_room(at), at});
  }
  return scans;
}

ConeMapping still() {
  ConeMapping mapping;
  mapping.drift_m = mapping.drift_rad = mapping.range_sigma_m = 0;
  return mapping;
}

/// From the middle of the room towards +x: how far it is free, and how thick the wall is [m].
struct Wall {
  double free_m = 0, thick_m = 0;
};
Wall wall_ahead(const MapRaster& raster) {
  Wall wall;
  for (double x = 0; x < 6; x += 0.01) {
    if (raster.at({x, 0.05}) == MapRaster::Cell::free) wall.free_m = x;
    if (raster.at({x, 0.05}) == MapRaster::Cell::occupied) wall.thick_m += 0.01;
  }
  return wall;
}

}  // namespace

TEST_CASE("cones draw a room with walls that are thick, about where they are") {
  const Wall wall = wall_ahead(cone_mapped(drive(), still()));
  CHECK(wall.free_m > 3.2);
  CHECK(wall.free_m < 4.05);
  CHECK(wall.thick_m >= 0.1);
}

TEST_CASE("the wider the beams, the thicker the walls, and the further they reach into the room") {
  ConeMapping narrow = still(), wide = still();
  narrow.cone_rad = 0.03;
  wide.cone_rad = 0.5;
  const Wall thin = wall_ahead(cone_mapped(drive(), narrow)), thick = wall_ahead(cone_mapped(drive(), wide));
  CHECK(thick.free_m < thin.free_m + 0.01);
}

TEST_CASE("the same seed gives the same map, another one another") {
  ConeMapping mapping;
  const MapRaster one = cone_mapped(drive(), mapping), again = cone_mapped(drive(), mapping);
  CHECK(one.cells == again.cells);
  mapping.seed = 2;
  CHECK(cone_mapped(drive(), mapping).cells != one.cells);
}

TEST_CASE("numbers without sense, and drives without scans, are refused by name") {
  CHECK_THROWS_WITH(cone_mapped({}, {}), Catch::Contains("no scan"));
  ConeMapping mapping;
  mapping.cone_rad = std::nan("");
  CHECK_THROWS_WITH(cone_mapped(drive(), mapping), Catch::Contains("cone"));
  mapping = {};
  mapping.resolution_m = 0;
  CHECK_THROWS_WITH(cone_mapped(drive(), mapping), Catch::Contains("cell"));
  mapping = {};
  mapping.blur_m = 1e9;
  CHECK_THROWS_WITH(cone_mapped(drive(), mapping), Catch::Contains("blur"));
}

TEST_CASE("walls beyond the reach of the beams are not drawn") {
  ConeMapping mapping = still();
  mapping.reach_m = 1;
  std::vector<PlacedScan> scans = drive();
  for (PlacedScan& placed : scans) placed.T_map_laser = Pose2(placed.T_map_laser.x() / 5, 0, 0);
  for (PlacedScan& placed : scans) placed.scan = scan_of_room(placed.T_map_laser);
  const MapRaster raster = cone_mapped(scans, mapping);
  CHECK(std::count(raster.cells.begin(), raster.cells.end(), MapRaster::Cell::occupied) == 0);
  CHECK(std::count(raster.cells.begin(), raster.cells.end(), MapRaster::Cell::free) > 100);
}

TEST_CASE("scans that see nothing leave a map of what was free") {
  std::vector<PlacedScan> scans = drive();
  for (PlacedScan& placed : scans) placed.scan.points.clear();
  const MapRaster raster = cone_mapped(scans, still());
  CHECK(std::count(raster.cells.begin(), raster.cells.end(), MapRaster::Cell::occupied) == 0);
}
