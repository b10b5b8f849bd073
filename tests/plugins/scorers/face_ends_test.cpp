#include "plugins/score_beams/face_ends.hpp"
#include "tests/map/view/walls.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace opal;
using namespace opal::score_beams;

namespace {

FaceEnds ends_of(std::shared_ptr<const SemanticMap> map) {
  return FaceEnds::of(MapView(std::move(map), "PlanarLidar2D"));
}

const Segment kUpper{{0, 0.1}, {4, 0.1}}, kLower{{4, 0}, {0, 0}};

/// Whether another wall of nearly the same heading passes where this one would be a little beyond its end.
bool goes_on(const std::vector<Geometry>& walls, std::size_t number) {
  const auto& wall = std::get<Segment>(walls[number]);
  const Point beyond = wall.end + 0.3 * wall.direction();
  for (std::size_t n = 0; n < walls.size(); ++n) {
    const auto& other = std::get<Segment>(walls[n]);
    if (n != number && other.direction().dot(wall.direction()) > 0.97 && distance_m(other, beyond) <= 0.15) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("the end of a face is found within the gate, and which of two ends it is") {
  const FaceEnds view = ends_of(map_of({kUpper, kLower}));
  const Point east(1, 0);
  const EndGate gate;
  CHECK(view.nearest({0.1, 0.1}, east, Tip::begin, gate).number() == FaceEndNumber(0));
  CHECK(view.nearest({3.9, 0.3}, east, Tip::end, gate).number() == FaceEndNumber(1));
  CHECK_FALSE(view.nearest({3.9, 0.1}, east, Tip::begin, gate).face.exists());
  CHECK(view.nearest({3.9, 0}, -east, Tip::begin, gate).number() == FaceEndNumber(2));  // the other side
  CHECK_FALSE(view.nearest({2, 0.1}, east, Tip::begin, gate).face.exists());
  CHECK_FALSE(view.nearest({0, 0.1}, unit_vector(0.3), Tip::begin, gate).face.exists());
  CHECK(view.nearest({0.15, 0.1}, east, Tip::begin, gate).gates == Approx(0.5));
  CHECK(view.nearest({0, 0.3}, east, Tip::begin, gate).gates == Approx(0.5));
  CHECK_FALSE(view.nearest({std::nan(""), 0}, east, Tip::begin, gate).face.exists());
  CHECK_FALSE(view.nearest({1e300, -1e300}, east, Tip::begin, gate).face.exists());
  const FaceEnds wide = ends_of(map_of({kUpper, Segment{{4000, 9000}, {4002, 9000}}}));  // cells of more than 2 m
  CHECK(wide.nearest({4002.1, 9000.1}, east, Tip::end, gate).number() == FaceEndNumber(3));
  CHECK(wide.nearest({3.9, 0.1}, east, Tip::end, gate).number() == FaceEndNumber(1));
}

TEST_CASE("where a wall goes on as another piece of it, there is no end") {
  const Point east(1, 0);
  for (const double gap_m : {0.0, 0.2}) {
    const FaceEnds view = ends_of(map_of({Segment{{0, 0}, {4, 0}}, Segment{{4 + gap_m, 0.05}, {7, 0.05}}}));
    CAPTURE(gap_m);
    CHECK_FALSE(view.nearest({4, 0}, east, Tip::end, {}).face.exists());
    CHECK_FALSE(view.nearest({4, 0}, east, Tip::begin, {}).face.exists());
    CHECK(view.nearest({7, 0}, east, Tip::end, {}).number() == FaceEndNumber(3));
  }
  const FaceEnds door = ends_of(map_of({Segment{{0, 0}, {4, 0}}, Segment{{4.9, 0}, {7, 0}}}));
  CHECK(door.nearest({4, 0}, east, Tip::end, {}).number() == FaceEndNumber(1));
  const FaceEnds corner = ends_of(map_of({Segment{{0, 0}, {4, 0}}, Segment{{4, 0}, {4, 3}}}));
  CHECK(corner.nearest({4, 0}, east, Tip::end, {}).number() == FaceEndNumber(1));
  CHECK(corner.nearest({4, 0}, {0, 1}, Tip::begin, {}).number() == FaceEndNumber(2));
}

TEST_CASE("ends of faces are those that a walk over all faces finds") {
  const auto walls = random_walls(400, 7);
  std::vector<bool> has_end;  // few go on as another: headings are at random
  for (std::size_t n = 0; n < walls.size(); ++n) has_end.push_back(!goes_on(walls, n));
  const FaceEnds view = ends_of(map_of(walls));
  std::mt19937 random(8);
  std::uniform_real_distribution<double> off(-0.3, 0.3), turn(-0.3, 0.3);
  const EndGate gate;
  int found = 0;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const auto& wall = std::get<Segment>(walls[k]);
    const Point p = wall.end + Point{off(random), off(random)};
    const double heading_rad = std::atan2(wall.direction().y(), wall.direction().x()) + turn(random);
    FaceEnd expected;
    for (std::size_t n = 0; n < walls.size(); ++n) {
      const auto& other = std::get<Segment>(walls[n]);
      if (!has_end[n] || other.direction().dot(unit_vector(heading_rad)) < std::cos(gate.angle_rad)) continue;
      const Point from = p - other.end;
      const double gates =
          std::hypot(other.direction().dot(from) / gate.along_m, cross(other.direction(), from) / gate.across_m);
      if (gates < expected.gates) expected = {MapFeatureNumber(n), Tip::end, gates};
    }
    const FaceEnd end = view.nearest(p, unit_vector(heading_rad), Tip::end, gate);
    CAPTURE(k, p.transpose(), heading_rad);
    CHECK(end.number() == expected.number());
    CHECK(end.gates == Approx(expected.gates));
    found += end.face.exists();
  }
  CHECK(found > 100);
}
