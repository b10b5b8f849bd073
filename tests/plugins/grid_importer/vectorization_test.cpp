// What becomes of what is drawn on a grid. Face lines run through the centres of the cells that a wall's surface is in.
#include "drawn_grid.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numbers>
#include <set>

namespace {

using namespace opal;
using namespace opal::test;

constexpr double kHere_m = 0.02;  // less than half a cell

Point centre(int column, int row) { return DrawnGrid::kCell_m * Point(column + 0.5, row + 0.5); }

bool runs(const Segment& face, const Point& begin, const Point& end, double tolerance_m) {
  return (face.begin - begin).norm() <= tolerance_m && (face.end - end).norm() <= tolerance_m;
}

bool has_face(const SemanticMap& map, const Point& begin, const Point& end, double tolerance_m = kHere_m) {
  const std::vector<Segment> faces = all<Segment>(map);
  return std::any_of(faces.begin(), faces.end(), [&](const Segment& f) { return runs(f, begin, end, tolerance_m); });
}

std::string text_of(const SemanticMap& map) {
  std::ostringstream text;
  for (const Segment& f : all<Segment>(map))
    text << "face " << f.begin.transpose() << " -> " << f.end.transpose() << "\n";
  for (const Circle& c : all<Circle>(map)) text << "circle " << c.center.transpose() << " r " << c.radius_m << "\n";
  return text.str();
}

void fill_disc(DrawnGrid& grid, double column, double row, double radius, std::uint8_t shade) {
  for (int r = 0; r < grid.rows(); ++r)
    for (int c = 0; c < grid.columns(); ++c)
      if (std::hypot(c - column, r - row) <= radius) grid.at(c, r) = shade;
}

/// As a SLAM program sees it: an outline, and unknown inside.
void draw_column(DrawnGrid& grid, double column, double row, double radius) {
  fill_disc(grid, column, row, radius + 0.5, DrawnGrid::kOccupied);
  fill_disc(grid, column, row, radius - 0.7, DrawnGrid::kUnknown);
}

/// Two rooms with a dotted wall and a pillar: something of everything, and nothing symmetric.
DrawnGrid flat() {
  DrawnGrid grid(220, 200);
  grid.room(10, 12, 150, 90);
  grid.fill(DrawnGrid::kOccupied, 80, 12, 82, 60);
  for (int column = 95; column <= 150; column += 3) grid.at(column, 45) = DrawnGrid::kOccupied;
  grid.fill(DrawnGrid::kOccupied, 30, 40, 37, 47);
  draw_column(grid, 55, 65, 5);
  return grid;
}

}  // namespace

TEST_CASE("a room is four faces that look inwards and four concave corners") {
  const auto map = import(DrawnGrid(140, 100).room(20, 30, 119, 89)).map;
  CAPTURE(text_of(*map));
  CHECK(all<Segment>(*map).size() == 4);
  CHECK(has_face(*map, centre(20, 30), centre(119, 30)));
  CHECK(has_face(*map, centre(119, 30), centre(119, 89)));
  CHECK(has_face(*map, centre(119, 89), centre(20, 89)));
  CHECK(has_face(*map, centre(20, 89), centre(20, 30)));
  const auto corners = all<OrientedPoint>(*map);
  REQUIRE(corners.size() == 4);
  for (const OrientedPoint& corner : corners) {
    CHECK(corner.opening_rad == Approx(std::numbers::pi / 2).margin(0.01));
    const Point inwards = (centre(70, 60) - corner.position).cwiseSign();
    CHECK(unit_vector(corner.heading_rad).dot(inwards) == Approx(std::sqrt(2.0)).margin(0.01));
  }
}

TEST_CASE("faces that meet in a corner share its point, and are one object") {
  const auto map = import(DrawnGrid(140, 100).room(20, 30, 119, 89)).map;
  REQUIRE(map->objects().size() == 1);
  CHECK(map->objects()[0].id == "wall-0001");
  CHECK(map->objects()[0].type == "opal:Wall");
  std::multiset<std::string> points;
  for (const MapFeature& feature : map->features()) {
    CHECK(feature.object == MapObjectNumber(0));
    CHECK(feature.sensor == "PlanarLidar2D");
    CHECK(feature.type == (kind_of(feature.geometry) == GeometryKind::segment ? "opal:Wall" : "opal:Corner"));
    points.insert(feature.points.begin(), feature.points.end());
  }
  for (const std::string& point : points) CHECK(points.count(point) == 3);  // two faces and the corner
}

TEST_CASE("a thick wall is two faces, each at its surface") {
  DrawnGrid grid(160, 100);
  grid.fill(DrawnGrid::kFree, 10, 10, 149, 89).fill(DrawnGrid::kOccupied, 30, 45, 129, 50);
  const auto map = import(grid).map;
  CAPTURE(text_of(*map));
  CHECK(has_face(*map, centre(30, 50), centre(129, 50)));
  CHECK(has_face(*map, centre(129, 45), centre(30, 45)));
}

TEST_CASE("a wall of one cell that is seen from both sides is two faces on one line") {
  DrawnGrid grid(160, 100);
  grid.fill(DrawnGrid::kFree, 10, 10, 149, 89).fill(DrawnGrid::kOccupied, 30, 45, 129, 45);
  const auto map = import(grid).map;
  CAPTURE(text_of(*map));
  CHECK(all<Segment>(*map).size() == 2);
  CHECK(has_face(*map, centre(30, 45), centre(129, 45)));
  CHECK(has_face(*map, centre(129, 45), centre(30, 45)));
}

TEST_CASE("a slanted wall is one straight face and no staircase") {
  DrawnGrid grid(260, 140);
  for (int column = 10; column < 250; ++column) {
    const double surface = 20 + 0.31 * (column - 10);
    for (int row = 0; row < 140; ++row)
      grid.at(column, row) = row < surface - 1   ? DrawnGrid::kUnknown
                             : row < surface + 1 ? DrawnGrid::kOccupied
                                                 : DrawnGrid::kFree;
  }
  const auto map = import(grid).map;
  CAPTURE(text_of(*map));
  const auto faces = all<Segment>(*map);
  REQUIRE(faces.size() == 1);
  CHECK(std::tan(faces[0].heading_rad()) == Approx(0.31).margin(0.002));
  CHECK(faces[0].length_m() == Approx(0.05 * 239 * std::hypot(1, 0.31)).margin(0.1));
}

TEST_CASE("a dotted wall before the unknown is one face") {
  const int pitch = GENERATE(2, 4, 5);  // cells: 0.1 to 0.25 m
  CAPTURE(pitch);
  DrawnGrid grid(200, 80);
  grid.fill(DrawnGrid::kFree, 10, 30, 189, 70);
  for (int column = 10; column <= 189; column += pitch) grid.at(column, 29) = DrawnGrid::kOccupied;
  const auto map = import(grid).map;
  CAPTURE(text_of(*map));
  REQUIRE(all<Segment>(*map).size() == 1);
  CHECK(all<Segment>(*map)[0].length_m() == Approx(0.05 * 179).margin(0.3));
}

TEST_CASE("gaps up to the bridging length are bridged, doors are not") {
  const auto [gap_cells, faces] = GENERATE(table<int, int>({{8, 1}, {12, 1}, {13, 2}, {18, 2}, {40, 2}}));
  CAPTURE(gap_cells);
  DrawnGrid grid(260, 80);
  grid.fill(DrawnGrid::kFree, 10, 20, 249, 70).fill(DrawnGrid::kOccupied, 10, 20, 109, 20);
  grid.fill(DrawnGrid::kOccupied, 110 + gap_cells, 20, 249, 20);
  const auto map = import(grid).map;
  CAPTURE(text_of(*map));
  CHECK(all<Segment>(*map).size() == static_cast<std::size_t>(faces));
}

TEST_CASE("the bridging length is an option") {
  DrawnGrid grid(260, 80);
  grid.fill(DrawnGrid::kFree, 10, 20, 249, 70).fill(DrawnGrid::kOccupied, 10, 20, 249, 20);
  grid.fill(DrawnGrid::kFree, 110, 20, 117, 20);
  CHECK(all<Segment>(*import(grid, {{"bridge_gap_m", 0.2}}).map).size() == 2);
  CHECK(all<Segment>(*import(grid, {{"bridge_gap_m", 0.5}}).map).size() == 1);
}

TEST_CASE("noise of a cell moves no face by more than a fifth of one") {
  DrawnGrid grid(300, 80);
  grid.fill(DrawnGrid::kFree, 10, 30, 289, 70);
  std::uint32_t seed = 12345;
  CAPTURE(seed);
  for (int column = 10; column <= 289; ++column) {
    seed = seed * 1664525 + 1013904223;  // Numerical Recipes' generator
    grid.at(column, 28 + static_cast<int>(seed >> 16) % 3) = DrawnGrid::kOccupied;
  }
  const auto map = import(grid).map;
  CAPTURE(text_of(*map));
  const auto faces = all<Segment>(*map);
  const auto longest = std::ranges::max_element(faces, {}, &Segment::length_m);
  REQUIRE(longest != faces.end());
  CHECK(longest->length_m() == Approx(0.05 * 279).margin(0.15));
  CHECK(longest->midpoint().y() == Approx(centre(0, 29).y()).margin(0.01));
  CHECK(longest->heading_rad() == Approx(0).margin(0.005));
}

TEST_CASE("a round column that stands alone is a circle, wherever it is on the raster") {
  const double radius = GENERATE(4.0, 6.0, 9.3, 11.0);
  const double shift = GENERATE(0.0, 0.37);
  CAPTURE(radius, shift);
  DrawnGrid grid(80, 80);
  grid.fill(DrawnGrid::kFree, 5, 5, 74, 74);
  draw_column(grid, 40 + shift, 41 - shift, radius);
  const auto map = import(grid).map;
  CAPTURE(text_of(*map));
  const auto circles = all<Circle>(*map);
  REQUIRE(circles.size() == 1);
  CHECK((circles[0].center - 0.05 * Point(40.5 + shift, 41.5 - shift)).norm() < 0.02);
  CHECK(circles[0].radius_m == Approx(0.05 * radius).margin(0.02));
  CHECK(all<Segment>(*map).empty());
  CHECK(map->objects()[0].id == "column-001");
  CHECK(map->objects()[0].type == "opal:Column");
}

TEST_CASE("a round column seen from one side only is a circle too") {
  DrawnGrid grid(80, 80);
  grid.fill(DrawnGrid::kFree, 5, 5, 74, 74);
  draw_column(grid, 40, 40, 7);
  for (int row = 5; row <= 74; ++row)
    for (int column = 40; column <= 74; ++column)
      if (std::abs(row - 40) <= 7) grid.at(column, row) = DrawnGrid::kUnknown;  // its shadow
  const auto map = import(grid).map;
  CAPTURE(text_of(*map));
  const auto circles = all<Circle>(*map);
  REQUIRE(circles.size() == 1);
  CHECK((circles[0].center - centre(40, 40)).norm() < 0.03);
  CHECK(circles[0].radius_m == Approx(0.35).margin(0.03));
}

TEST_CASE("a square pillar is four faces with convex corners, and a column") {
  const int size = GENERATE(7, 10, 16);
  CAPTURE(size);
  DrawnGrid grid(80, 80);
  grid.fill(DrawnGrid::kFree, 5, 5, 74, 74).fill(DrawnGrid::kOccupied, 30, 30, 30 + size, 30 + size);
  const auto map = import(grid).map;
  CAPTURE(text_of(*map));
  CHECK(all<Circle>(*map).empty());
  CHECK(all<Segment>(*map).size() == 4);
  CHECK(has_face(*map, centre(30, 30 + size), centre(30 + size, 30 + size)));
  const auto corners = all<OrientedPoint>(*map);
  REQUIRE(corners.size() == 4);
  for (const OrientedPoint& corner : corners) CHECK(corner.opening_rad == Approx(1.5 * std::numbers::pi).margin(0.01));
  REQUIRE(map->objects().size() == 1);
  CHECK(map->objects()[0].type == "opal:Column");
}

TEST_CASE("a round room is no column, and neither is a column that touches a wall") {
  DrawnGrid room(80, 80);
  fill_disc(room, 40, 40, 9.5, DrawnGrid::kOccupied);
  fill_disc(room, 40, 40, 8.5, DrawnGrid::kFree);
  CHECK(all<Circle>(*import(room).map).empty());
  DrawnGrid wall(80, 80);
  wall.fill(DrawnGrid::kFree, 5, 20, 74, 74).fill(DrawnGrid::kOccupied, 5, 20, 74, 20);
  draw_column(wall, 40, 28, 7);
  CHECK(all<Circle>(*import(wall).map).empty());
}

TEST_CASE("no columns are sought if none may be large enough") {
  DrawnGrid grid(80, 80);
  grid.fill(DrawnGrid::kFree, 5, 5, 74, 74);
  draw_column(grid, 40, 40, 7);
  CHECK(all<Circle>(*import(grid, {{"max_column_radius_m", 0}}).map).empty());
}

TEST_CASE("a grid without a wall is refused") {
  CHECK_THROWS_WITH(import(DrawnGrid(30, 20)),
                    Catch::Contains("0 cells are occupied and 0 free, and no wall is between them"));
}

TEST_CASE("the same grid gives the same map") {
  CHECK(import(flat()).map->to_json_ld() == import(flat()).map->to_json_ld());
}

TEST_CASE("a grid shifted by whole cells gives the shifted map") {
  const auto map = import(flat()).map;
  const auto moved = import(flat().shifted(37, 61)).map;
  const Pose2 T_moved_map(37 * DrawnGrid::kCell_m, 61 * DrawnGrid::kCell_m, 0);
  REQUIRE(moved->features().size() == map->features().size());
  for (std::size_t k = 0; k < map->features().size(); ++k) {
    const MapFeature& feature = map->features()[k];
    CAPTURE(feature.id);
    CHECK(moved->features()[k].id == feature.id);
    const Geometry expected = transformed(T_moved_map, feature.geometry);
    CHECK((anchor_of(moved->features()[k].geometry) - anchor_of(expected)).norm() < 1e-9);
  }
}

TEST_CASE("a grid turned by 90 degrees gives the turned map") {
  const auto map = import(flat()).map;
  const auto turned = import(flat().turned_left()).map;
  const Pose2 T_turned_map(flat().rows() * DrawnGrid::kCell_m, 0, std::numbers::pi / 2);
  CAPTURE(text_of(*map), text_of(*turned));
  CHECK(turned->features().size() == map->features().size());
  for (const Segment& face : all<Segment>(*map)) {
    const Segment expected = transformed(T_turned_map, face);
    CHECK(has_face(*turned, expected.begin, expected.end, 0.01));
  }
  for (const Circle& circle : all<Circle>(*map)) {
    REQUIRE(all<Circle>(*turned).size() == 1);
    CHECK((all<Circle>(*turned)[0].center - T_turned_map * circle.center).norm() < 0.001);
  }
}
