// Plans that somebody drew, where all walls run along rows and columns: they come in as drawn.
#include "drawn_grid.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

namespace {

using namespace opal;
using namespace opal::test;

/// A room whose upper wall has jogs of so many cells, `arm` cells apart, with a wall so thick around it.
DrawnGrid jogged_room(int arm, int jog, int thick) {
  DrawnGrid plan(260, 160);
  const int left = 20, right = 230, bottom = 20, top = 110;
  const auto fill = [&](std::uint8_t shade, int wider) {
    for (int begin = left, k = 0; begin < right; begin += arm, ++k)
      plan.fill(shade, begin - wider, bottom - wider, std::min(begin + arm, right) - 1 + wider,
                top + (k % 2) * jog + wider);
  };
  fill(DrawnGrid::kOccupied, thick);
  fill(DrawnGrid::kFree, 0);
  return plan;
}

/// The largest angle of a face against rows and columns.
double largest_slant_rad(const SemanticMap& map) {
  double largest = 0;
  for (const Segment& face : all<Segment>(map)) {
    const Point d = face.direction().cwiseAbs();
    largest = std::max(largest, std::min(d.x(), d.y()));
  }
  return largest;
}

int faces_at_height(const SemanticMap& map, double y_m) {
  const auto faces = all<Segment>(map);
  return static_cast<int>(std::count_if(faces.begin(), faces.end(), [&](const Segment& face) {
    return std::abs(face.begin.y() - y_m) < 0.01 && std::abs(face.end.y() - y_m) < 0.01;
  }));
}

}  // namespace

TEST_CASE("walls with a jog of a quarter of a metre come in as drawn, with the jog") {
  const int arm = GENERATE(12, 21, 40, 70), jog = GENERATE(4, 5, 7), thick = GENERATE(1, 2, 3);
  CAPTURE(arm, jog, thick);
  const MapImport plan = import(jogged_room(arm, jog, thick));
  CHECK(largest_slant_rad(*plan.map) < 1e-6);
  CHECK(plan.map->origin().smear_m == 0);
  const int arms = (210 + arm - 1) / arm;
  CHECK(faces_at_height(*plan.map, (111 + 0.5) * 0.05) == (arms + 1) / 2);
  CHECK(faces_at_height(*plan.map, (111 + jog + 0.5) * 0.05) == arms / 2);
  CHECK(all<OrientedPoint>(*plan.map).size() == all<Segment>(*plan.map).size());
}

TEST_CASE("slanted walls of a drawn plan stay straight, and both sides of a thin wall are there") {
  DrawnGrid plan = jogged_room(70, 5, 1);
  for (int k = 0; k < 120; ++k) plan.fill(DrawnGrid::kOccupied, 60 + k, 40 + k / 8, 60 + k, 41 + k / 8);
  plan.fill(DrawnGrid::kOccupied, 200, 20, 200, 70).fill(DrawnGrid::kOccupied, 201, 71, 201, 72);
  const MapImport imported = import(plan);
  int slanted = 0, at_wall = 0;
  for (const Segment& face : all<Segment>(*imported.map)) {
    slanted += std::abs(face.direction().y()) > 0.1 && std::abs(face.direction().x()) > 0.1 && face.length_m() > 5;
    at_wall += std::abs(face.midpoint().x() - 200.5 * 0.05) < 0.06 && face.length_m() > 2;
  }
  CHECK(slanted == 2);
  CHECK(at_wall == 2);
}

TEST_CASE("a niche in a drawn wall keeps its opening, a short gap is bridged") {
  DrawnGrid plan(160, 100);
  plan.fill(DrawnGrid::kOccupied, 9, 9, 150, 90).fill(DrawnGrid::kFree, 10, 10, 149, 80);
  plan.fill(DrawnGrid::kFree, 60, 80, 69, 85);  // half a metre wide
  const MapImport imported = import(plan);
  CHECK(faces_at_height(*imported.map, 81.5 * 0.05) == 2);
  CHECK(faces_at_height(*imported.map, 86.5 * 0.05) == 1);
}

TEST_CASE("a cell that stands alone is no face, even where faces may be as short as it") {
  DrawnGrid plan = jogged_room(70, 5, 1);
  plan.fill(DrawnGrid::kOccupied, 100, 60, 100, 60);
  const MapImport map = import(plan, {{"min_face_m", 0.01}});
  for (const Segment& face : all<Segment>(*map.map)) CHECK(face.length_m() > 0.04);
}
