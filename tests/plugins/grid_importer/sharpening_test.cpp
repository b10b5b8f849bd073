// Grids without sharp borders: a strip of cells that are neither free nor occupied lies before every wall.
#include "drawn_grid.hpp"

#include "plugins/grid_importer/blur.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

namespace {

using namespace opal;
using namespace opal::test;
using grid_importer::Cell;
using grid_importer::Occupancy;
using grid_importer::OccupancyGrid;

/// A room of 8 x 5 m in cells of 0.1 m, with `strip` unknown cells between its floor and its walls of two cells.
OccupancyGrid room_with_strip(int strip) {
  OccupancyGrid grid(100, 70, 0.1, Pose2());
  const auto fill = [&](Occupancy what, int inset) {
    for (int row = 8 + inset; row < 62 - inset; ++row)
      for (int column = 8 + inset; column < 92 - inset; ++column) grid.set({column, row}, what);
  };
  fill(Occupancy::occupied, 0);
  fill(Occupancy::unknown, 2);
  fill(Occupancy::free, 2 + strip);
  return grid;
}

int count(const OccupancyGrid& grid, Occupancy what) {
  return static_cast<int>(std::count(grid.cells().begin(), grid.cells().end(), what));
}

/// The same room, drawn as an image of 0.05 m cells.
DrawnGrid drawn_room_with_strip(int strip) {
  DrawnGrid grid(200, 140);
  grid.fill(DrawnGrid::kOccupied, 16, 16, 183, 123);
  grid.fill(DrawnGrid::kUnknown, 17, 17, 182, 122);
  grid.fill(DrawnGrid::kFree, 17 + strip, 17 + strip, 182 - strip, 122 - strip);
  return grid;
}

}  // namespace

TEST_CASE("a sharp grid stays as it is") {
  const OccupancyGrid grid = room_with_strip(0);
  CHECK(grid_importer::blurred_share(grid) == 0);
  CHECK(grid_importer::sharpened(grid).cells() == grid.cells());
}

TEST_CASE("strips between free and occupied become free, and nothing else does") {
  const int strip = GENERATE(1, 2, 4);
  const OccupancyGrid grid = room_with_strip(strip), sharp = grid_importer::sharpened(grid);
  CAPTURE(strip);
  CHECK(grid_importer::blurred_share(grid) == 1);
  CHECK(count(sharp, Occupancy::occupied) == count(grid, Occupancy::occupied));
  const int room = count(room_with_strip(0), Occupancy::free), free = count(sharp, Occupancy::free);
  CHECK(free <= room);
  CHECK(free >= room - 4 * strip * strip);  // in the corners the way across is longer
}

TEST_CASE("what is wider than a strip was never seen, and stays unknown") {
  const OccupancyGrid grid = room_with_strip(8);
  CHECK(grid_importer::sharpened(grid).cells() == grid.cells());
}

TEST_CASE("the walls of a blurred room come out where they are") {
  const auto sharp = all<Segment>(*import(drawn_room_with_strip(0)).map);
  const auto blurred = all<Segment>(*import(drawn_room_with_strip(7)).map);
  REQUIRE(sharp.size() == 4);
  REQUIRE(blurred.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(distance_m(blurred[k], sharp[k].begin) < 0.051);
    CHECK(distance_m(blurred[k], sharp[k].end) < 0.051);
  }
}
