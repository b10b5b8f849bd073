// Walls that stand thicker in a grid than they are: how they are made, how they are found out, how they are put right.
#include "drawn_grid.hpp"

#include "plugins/grid_importer/distance_transform.hpp"
#include "plugins/grid_importer/smear.hpp"
#include "tests/kit/import_report.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

namespace {

using namespace opal;
using namespace opal::test;
using grid_importer::Cell;
using grid_importer::Occupancy;
using grid_importer::OccupancyGrid;

OccupancyGrid grid_of(const std::vector<std::string>& rows_from_top, double cell_m) {
  OccupancyGrid grid(static_cast<int>(rows_from_top[0].size()), static_cast<int>(rows_from_top.size()), cell_m,
                     Pose2());
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column) {
      const char c = rows_from_top[static_cast<std::size_t>(grid.rows() - 1 - row)][static_cast<std::size_t>(column)];
      grid.set({column, row}, c == '#' ? Occupancy::occupied : c == '.' ? Occupancy::free : Occupancy::unknown);
    }
  return grid;
}

std::vector<std::string> text_of(const OccupancyGrid& grid) {
  std::vector<std::string> rows;
  for (int row = grid.rows() - 1; row >= 0; --row) {
    rows.emplace_back();
    for (int column = 0; column < grid.columns(); ++column) {
      const Occupancy there = grid.at({column, row});
      rows.back() += there == Occupancy::occupied ? '#' : there == Occupancy::free ? '.' : '?';
    }
  }
  return rows;
}

/// Two rooms beside each other, with a slanted wall in one, a free standing wall in the other, and a door between them.
DrawnGrid two_smeared_rooms() {
  DrawnGrid grid(260, 160);
  grid.room(10, 10, 130, 140);
  grid.room(130, 10, 240, 140);
  grid.fill(DrawnGrid::kFree, 130, 60, 130, 90);  // the door
  for (int k = 0; k < 70; ++k) grid.fill(DrawnGrid::kOccupied, 40 + k, 40 + k / 2, 40 + k, 41 + k / 2);
  grid.fill(DrawnGrid::kOccupied, 180, 50, 181, 110);
  return grid;
}

/// The mapped face that looks the same way as this one, nearest to its middle.
const Segment* face_like(const std::vector<Segment>& faces, const Segment& wanted) {
  const Segment* best = nullptr;
  for (const Segment& face : faces)
    if (face.direction().dot(wanted.direction()) > 0.95 &&
        (!best || distance_m(face, wanted.midpoint()) < distance_m(*best, wanted.midpoint())))
      best = &face;
  return best;
}

}  // namespace

TEST_CASE("the distance transform is the distance to the nearest cell, by definition") {
  std::mt19937 random(GENERATE(range(1u, 20u)));
  OccupancyGrid grid(17, 11, 0.05, Pose2());
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column)
      if (random() % 8 == 0) grid.set({column, row}, Occupancy::occupied);
  grid.set({3, 4}, Occupancy::occupied);
  const std::vector<float> distance = grid_importer::distance_to_occupied(grid);
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column) {
      double nearest = 1e9;
      for (int r = 0; r < grid.rows(); ++r)
        for (int c = 0; c < grid.columns(); ++c)
          if (grid.at({c, r}) == Occupancy::occupied) nearest = std::min(nearest, std::hypot(r - row, c - column));
      CHECK(distance[grid.index_of({column, row})] == Approx(nearest).margin(1e-5));
    }
}

TEST_CASE("smear grows occupied cells to a disc and makes cells of ten centimetres") {
  const OccupancyGrid fine = grid_of({"............", "............", "............", "............", "....#.......",
                                      "............", "............", "............", "............", "??????......"},
                                     0.05);
  const OccupancyGrid thick = grid_importer::smeared(fine, 0.2);
  CHECK(thick.resolution_m() == Approx(0.1));
  CHECK(text_of(thick) == std::vector<std::string>{"......", ".##...", ".###..", "..#...", "......"});
}

TEST_CASE("a grid of large cells is smeared, but gets no larger cells") {
  const OccupancyGrid large = grid_of({".....", ".....", "..#..", ".....", "....."}, 0.2);
  CHECK(text_of(grid_importer::smeared(large, 0.4)) ==
        std::vector<std::string>{".....", "..#..", ".###.", "..#..", "....."});
}

TEST_CASE("taking smear off leaves the middle of every stroke, and gives the rest to what is nearest") {
  const std::string free(300, '.'), wall(300, '#'), unknown(300, '?');
  const OccupancyGrid thick = grid_of({free, free, wall, wall, wall, wall, wall, unknown, unknown}, 0.1);
  CHECK(grid_importer::estimate_smear_m(thick) == Approx(0.4));
  const std::vector<std::string> thin = text_of(grid_importer::unsmeared(thick, 0.4));
  for (std::size_t row = 0; row < thin.size(); ++row) {
    CAPTURE(row);
    CHECK(thin[row].substr(3, 290) == (row < 4 ? free : row == 4 ? wall : unknown).substr(3, 290));
  }
}

TEST_CASE("strokes that were seen from one side tell the smear, whatever thin things stand in the room") {
  const std::string free(160, '.'), wall(160, '#'), unknown(160, '?');
  std::string posts(160, '.');
  for (std::size_t k = 2; k < posts.size(); k += 4) posts[k] = '#';  // each is one cell
  std::vector<std::string> rows{free, wall, wall, wall, wall, wall, unknown, unknown};
  for (int k = 0; k < 6; ++k) {
    rows.insert(rows.begin(), posts);
    rows.insert(rows.begin(), free);
  }
  CHECK(grid_importer::estimate_smear_m(grid_of(rows, 0.1)) == Approx(0.4));
}

TEST_CASE("a clean grid has no smear, however thick a wall is once") {
  DrawnGrid grid = two_smeared_rooms();
  CHECK(import(grid).map->origin().smear_m == 0);
  grid.fill(DrawnGrid::kOccupied, 60, 100, 110, 112);
  CHECK(import(grid).map->origin().smear_m == 0);
}

TEST_CASE("faces of thick walls are within five centimetres of the true ones, or a cell if smear is half cells") {
  const double smear_m = GENERATE(0.2, 0.3, 0.4, 0.5);
  const double tolerance_m = smear_m == 0.2 || smear_m == 0.4 ? 0.05 : 0.10;
  const auto clean = import(two_smeared_rooms()).map;
  const MapImport thick = import(two_smeared_rooms(), {{"thicken_m", smear_m}});
  CAPTURE(smear_m);
  CHECK(thick.map->origin().smear_m == Approx(smear_m).margin(0.1));
  CHECK(says(thick, "thicker in the grid than they are"));
  const std::vector<Segment> faces = all<Segment>(*thick.map);
  int compared = 0;
  for (const Segment& wanted : all<Segment>(*clean)) {
    if (wanted.length_m() < 1) continue;
    const Segment* face = face_like(faces, wanted);
    REQUIRE(face);
    CAPTURE(wanted.begin.transpose(), wanted.end.transpose(), face->begin.transpose(), face->end.transpose());
    CHECK(std::abs(wanted.normal().dot(face->midpoint() - wanted.midpoint())) < tolerance_m + 1e-4);
    ++compared;
  }
  CHECK(compared >= 10);
}

TEST_CASE("how thick walls may be made is checked") {
  CHECK_THROWS_WITH(import(two_smeared_rooms(), {{"thicken_m", 3}}),
                    Catch::Contains("thicken_m") && Catch::Contains("from 0 to 2"));
}
