#include "drawn_grid.hpp"

#include <opal/common/error.hpp>
#include "map_tools/map_raster.hpp"

#include <catch2/catch.hpp>

#include <fstream>

using namespace opal;
using namespace opal::test;
using Cell = MapRaster::Cell;

namespace {

DrawnGrid two_rooms() { return DrawnGrid(260, 160).room(20, 20, 120, 130).room(120, 20, 230, 130); }

/// Length of all faces, and how far their ends are from the nearest face of the other map at most.
double faces_m(const SemanticMap& map) {
  double sum = 0;
  for (const Segment& face : all<Segment>(map)) sum += face.length_m();
  return sum;
}

double farthest_end_m(const SemanticMap& map, const SemanticMap& other) {
  double farthest = 0;
  for (const Segment& face : all<Segment>(map))
    for (const Point& end : {face.begin, face.end}) {
      double nearest = 1e9;
      for (const Segment& candidate : all<Segment>(other)) nearest = std::min(nearest, distance_m(candidate, end));
      farthest = std::max(farthest, nearest);
    }
  return farthest;
}

}  // namespace

TEST_CASE("a raster reads back as the map that it was made of") {
  const auto map = import(two_rooms()).map;
  const TemporaryFolder folder;
  const std::string yaml = folder.path() + "/raster.yaml";
  write_raster(rasterized(*map), yaml);
  const auto again = grid_importer()->import(yaml).map;
  CHECK(faces_m(*again) == Approx(faces_m(*map)).epsilon(0.03));
  CHECK(farthest_end_m(*again, *map) < 0.11);
  CHECK(farthest_end_m(*map, *again) < 0.11);
}

TEST_CASE("what faces look at is free, what they are made of is occupied, what nobody sees is unknown") {
  const MapRaster raster = rasterized(*import(two_rooms()).map);
  CHECK(raster.at(Point(3, 3)) == Cell::free);
  CHECK(raster.at(Point(9, 4)) == Cell::free);
  CHECK(raster.at(Point(6.02, 3)) == Cell::occupied);
  CHECK(raster.at(Point(0.3, 3)) == Cell::unknown);
  CHECK(raster.at(Point(-50, 3)) == Cell::unknown);
}

TEST_CASE("resolution and border are what was asked for") {
  const auto map = import(two_rooms()).map;
  RasterOptions options;
  options.resolution_m = 0.2;
  options.border_m = 3;
  const MapRaster raster = rasterized(*map, options);
  CHECK(raster.resolution_m == 0.2);
  CHECK(raster.columns == Approx((10.5 + 6) / 0.2).margin(3));
  CHECK(raster.rows == Approx((5.5 + 6) / 0.2).margin(3));
}

TEST_CASE("a raster that makes no sense is an error that says so") {
  const auto map = import(two_rooms()).map;
  CHECK_THROWS_AS(rasterized(*map, {0, 1}), ConfigError);
  CHECK_THROWS_AS(rasterized(*map, {0.05, -1}), ConfigError);
  CHECK_THROWS_WITH(rasterized(*map, {0.001, 1000}), Catch::Contains("10^8"));
  const auto nothing = SemanticMap::make("nothing", {}, {});
  CHECK_THROWS_WITH(rasterized(*nothing), Catch::Contains("nothing") && Catch::Contains("surface"));
  CHECK_THROWS_WITH(write_raster(rasterized(*map), "/nowhere/a.yaml"), Catch::Contains("/nowhere/a.pgm"));
}

TEST_CASE("a raster is read again, whatever its name") {
  const std::string name = GENERATE("hall", "hall #2", "it's: a hall", "- hall", "*hall", "hall, 2nd {floor}");
  CAPTURE(name);
  const auto map = import(two_rooms()).map;
  const TemporaryFolder folder;
  const std::string yaml = folder.path_of(name + ".yaml");
  write_raster(rasterized(*map, {}), yaml);
  CHECK(faces_m(*grid_importer()->import(yaml).map) == Approx(faces_m(*map)).epsilon(0.03));
}
