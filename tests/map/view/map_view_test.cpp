#include <opal/common/error.hpp>
#include <opal/map/view/map_view.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace opal;

namespace {

std::shared_ptr<const SemanticMap> map_of(const std::vector<Geometry>& geometries) {
  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  for (const Geometry& geometry : geometries) {
    const int number = static_cast<int>(features.size());
    const bool column = kind_of(geometry) == GeometryKind::circle;
    objects.push_back({"object-" + std::to_string(number), column ? "opal:Column" : "opal:Wall", {number}});
    MapFeature feature;
    feature.id = "feature-" + std::to_string(number);
    feature.object = number;
    feature.type = column ? "opal:Column" : "opal:Wall";
    feature.sensor = "PlanarLidar2D";
    feature.geometry = geometry;
    features.push_back(feature);
  }
  return SemanticMap::make("test", objects, features);
}

std::vector<Geometry> random_walls(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 60), size(0.2, 9), heading(-3.14, 3.14);
  std::vector<Geometry> walls;
  for (int k = 0; k < count; ++k) {
    const Point begin(place(random), place(random));
    walls.push_back(Segment{begin, begin + size(random) * unit_vector(heading(random))});
  }
  return walls;
}

/// A wall seen from both sides, 0.1 m thick, along the x axis.
const Segment kUpper{{0, 0.1}, {4, 0.1}}, kLower{{4, 0}, {0, 0}};

}  // namespace

TEST_CASE("features within a radius are those that a walk over all features finds") {
  const auto walls = random_walls(300, 5);
  const MapView view(map_of(walls), "PlanarLidar2D");
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-5, 65), radius(0.1, 20);
  for (int query = 0; query < 100; ++query) {
    const Point p(place(random), place(random));
    const double r = radius(random);
    std::vector<int> expected;
    for (std::size_t k = 0; k < walls.size(); ++k)
      if (distance_m(walls[k], p) <= r) expected.push_back(static_cast<int>(k));
    std::vector<int> found = view.within(p, r);
    std::sort(found.begin(), found.end());
    CAPTURE(query, p.transpose(), r);
    CHECK(found == expected);
  }
}

TEST_CASE("clearance is the distance to the nearest surface, within a cell") {
  const auto walls = random_walls(60, 8);
  const MapView view(map_of(walls), "PlanarLidar2D");
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-5, 65);
  for (int query = 0; query < 500; ++query) {
    const Point p(place(random), place(random));
    double nearest = MapView::clearance_cap_m();
    for (const Geometry& wall : walls) nearest = std::min(nearest, distance_m(wall, p));
    CAPTURE(query, p.transpose());
    CHECK(std::abs(view.clearance_m(p) - nearest) < 0.08);
  }
}

TEST_CASE("of a thin wall's two faces, the one that faces the viewer is found") {
  const MapView view(map_of({kUpper, kLower}), "PlanarLidar2D");
  CHECK(view.nearest_facing({2, 0.05}, {0, -1}) == 0);
  CHECK(view.nearest_facing({2, 0.05}, {0, 1}) == 1);
  CHECK(view.nearest_facing({2, 3}, {0, -1}) == -1);
}

TEST_CASE("a ray finds the first wall it crosses, and says if it comes from behind") {
  const MapView view(map_of({kUpper, Segment{{0, -2}, {4, -2}}, Circle{{2, 3}, 0.3}}), "PlanarLidar2D");
  const auto from_above = view.first_crossing({1, 2}, {1, -3}, 0.2);
  CHECK(from_above.feature == 0);
  CHECK(from_above.range_m == Approx(1.9).margin(0.01));
  CHECK_FALSE(from_above.from_behind);
  CHECK(view.first_crossing({1, -1}, {1, 1}, 0.2).from_behind);
  CHECK(view.first_crossing({2, 5}, {2, 1}, 0.2).feature == 2);
  CHECK(view.first_crossing({1, 2}, {1, 0.0}, 0.2).feature == -1);   // overshoots by less than the margin
  CHECK(view.first_crossing({5, 2}, {5, -3}, 0.2).feature == -1);    // passes beside
  CHECK(view.first_crossing({1, 2}, {1, 2}, 0.2).feature == -1);     // no way at all
}

TEST_CASE("faces that lie on one straight line and look the same way share its number, wherever the map lies") {
  for (const Pose2& moved : {Pose2(), Pose2(-40, 300, 0.4), Pose2(7, 7, 2.9)}) {
    std::vector<Geometry> geometries;
    const auto add = [&](const Point& begin, const Point& end) { geometries.push_back(Segment{moved * begin, moved * end}); };
    add({0, 0}, {6, 0});
    add({7, 0.1}, {9, 0.1});     // the next piece
    add({9, -0.05}, {9.4, 0});   // a short one, hardly askew
    add({42, 0}, {43, 0});       // beyond 30 m
    add({6, -0.1}, {0, -0.1});   // the other side of the wall
    add({0, 0.6}, {6, 0.6});     // beside it
    add({6, 0}, {6, 3});         // across
    geometries.push_back(Circle{moved * Point(8, 0), 0.2});
    const MapView view(map_of(geometries), "PlanarLidar2D");
    std::vector<int> lines;
    for (std::size_t k = 0; k < geometries.size(); ++k) lines.push_back(view.surface(static_cast<int>(k)).line);
    CAPTURE(moved.x(), moved.y(), moved.heading_rad());
    CHECK(lines == std::vector<int>{0, 0, 0, 3, 4, 5, 6, 7});
  }
}

TEST_CASE("one line goes on as far as each piece follows the one before, in both directions") {
  for (const double turned_rad : {0.0, 0.7, -2.3}) {
    std::vector<Geometry> geometries;
    for (int k : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, -1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11})
      geometries.push_back(transformed(Pose2(3, 5, turned_rad), Segment{{25.0 * k, 0.01 * k}, {25.0 * k + 2, 0.01 * k}}));
    const MapView view(map_of(geometries), "PlanarLidar2D");
    for (int number : view.features()) {
      CAPTURE(turned_rad, number);
      CHECK(view.surface(number).line == view.surface(0).line);
    }
  }
}

TEST_CASE("far outside the map there is nothing, whatever is asked") {
  const MapView view(map_of({kUpper}), "PlanarLidar2D");
  for (const Point& p : {Point(1e9, 1e9), Point(-1e9, 3), Point(std::nan(""), 0)}) {
    CHECK(view.nearest_facing(p, {0, -1}) == -1);
    CHECK(view.clearance_m(p) == MapView::clearance_cap_m());
    CHECK(view.likelihood_field(p) == 0);
  }
}

TEST_CASE("likelihood_field with slack, and in large cells, is no less than what it stands for") {
  const MapView view(map_of(random_walls(40, 9)), "PlanarLidar2D");
  std::mt19937 random(10);
  std::uniform_real_distribution<double> place(-2, 62), step(-0.2, 0.2), direction(-8, 8);
  constexpr double kCellDiagonal_m = 0.15;
  for (int k = 0; k < 300; ++k) {
    std::vector<Point> points;
    for (int n = 0; n < 12; ++n) points.emplace_back(direction(random), direction(random));
    const Point here(place(random), place(random)), near(here + Point(step(random), step(random)));
    float sum = 0;
    for (const Point& point : points) sum += view.likelihood_field(here + point);
    CHECK(view.likelihood_field_sum(points, here) == Approx(sum));
    CHECK(view.coarse_likelihood_field_sum(points, here) >= sum - 1e-4f);
    CHECK(view.likelihood_field_sum(points, near, (near - here).norm() + kCellDiagonal_m) >= sum - 1e-4f);
  }
}

TEST_CASE("a sensor that perceives nothing of a map is refused by name") {
  CHECK_THROWS_WITH(MapView(map_of({kUpper}), "Camera"),
                    "test: holds no feature that sensor 'Camera' can perceive");
}

TEST_CASE("the end of a face is found within the gate, and which of two ends it is") {
  const MapView view(map_of({kUpper, kLower}), "PlanarLidar2D");
  const Point east(1, 0);
  const EndGate gate;
  CHECK(view.face_end_near({0.1, 0.1}, east, Tip::begin, gate).number() == 0);
  CHECK(view.face_end_near({3.9, 0.3}, east, Tip::end, gate).number() == 1);
  CHECK(view.face_end_near({3.9, 0.1}, east, Tip::begin, gate).face == -1);
  CHECK(view.face_end_near({3.9, 0}, -east, Tip::begin, gate).number() == 2);  // the other side
  CHECK(view.face_end_near({2, 0.1}, east, Tip::begin, gate).face == -1);
  CHECK(view.face_end_near({0, 0.1}, unit_vector(0.3), Tip::begin, gate).face == -1);
  CHECK(view.face_end_near({0.15, 0.1}, east, Tip::begin, gate).gates == Approx(0.5));
  CHECK(view.face_end_near({0, 0.3}, east, Tip::begin, gate).gates == Approx(0.5));
  CHECK(view.face_end_near({std::nan(""), 0}, east, Tip::begin, gate).face == -1);
  CHECK(view.face_end_near({1e300, -1e300}, east, Tip::begin, gate).face == -1);
  const MapView wide(map_of({kUpper, Segment{{4000, 9000}, {4002, 9000}}}), "PlanarLidar2D");  // cells of more than 2 m
  CHECK(wide.face_end_near({4002.1, 9000.1}, east, Tip::end, gate).number() == 3);
  CHECK(wide.face_end_near({3.9, 0.1}, east, Tip::end, gate).number() == 1);
}

TEST_CASE("where a wall goes on as another piece of it, there is no end") {
  const Point east(1, 0);
  for (const double gap_m : {0.0, 0.2}) {
    const MapView view(map_of({Segment{{0, 0}, {4, 0}}, Segment{{4 + gap_m, 0.05}, {7, 0.05}}}), "PlanarLidar2D");
    CAPTURE(gap_m);
    CHECK(view.face_end_near({4, 0}, east, Tip::end, {}).face == -1);
    CHECK(view.face_end_near({4, 0}, east, Tip::begin, {}).face == -1);
    CHECK(view.face_end_near({7, 0}, east, Tip::end, {}).number() == 3);
  }
  const MapView door(map_of({Segment{{0, 0}, {4, 0}}, Segment{{4.9, 0}, {7, 0}}}), "PlanarLidar2D");
  CHECK(door.face_end_near({4, 0}, east, Tip::end, {}).number() == 1);
  const MapView corner(map_of({Segment{{0, 0}, {4, 0}}, Segment{{4, 0}, {4, 3}}}), "PlanarLidar2D");
  CHECK(corner.face_end_near({4, 0}, east, Tip::end, {}).number() == 1);
  CHECK(corner.face_end_near({4, 0}, {0, 1}, Tip::begin, {}).number() == 2);
}

TEST_CASE("ends of faces are those that a walk over all faces finds") {
  const auto walls = random_walls(400, 7);  // headings at random: none goes on as another
  const MapView view(map_of(walls), "PlanarLidar2D");
  std::mt19937 random(8);
  std::uniform_real_distribution<double> off(-0.3, 0.3), turn(-0.3, 0.3);
  const EndGate gate;
  int found = 0;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const auto& wall = std::get<Segment>(walls[k]);
    const Point p = wall.end + Point(off(random), off(random));
    const double heading_rad = std::atan2(wall.direction().y(), wall.direction().x()) + turn(random);
    FaceEnd expected;
    for (std::size_t n = 0; n < walls.size(); ++n) {
      const auto& other = std::get<Segment>(walls[n]);
      if (other.direction().dot(unit_vector(heading_rad)) < std::cos(gate.angle_rad)) continue;
      const Point from = p - other.end;
      const double gates = std::hypot(other.direction().dot(from) / gate.along_m, cross(other.direction(), from) / gate.across_m);
      if (gates < expected.gates) expected = {static_cast<int>(n), Tip::end, gates};
    }
    const FaceEnd end = view.face_end_near(p, unit_vector(heading_rad), Tip::end, gate);
    CAPTURE(k, p.transpose(), heading_rad);
    CHECK(end.number() == expected.number());
    CHECK(end.gates == Approx(expected.gates));
    found += end.face >= 0;
  }
  CHECK(found > 100);
}
