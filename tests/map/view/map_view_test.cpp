#include <opal/common/error.hpp>
#include <opal/map/view/map_view.hpp>

#include "walls.hpp"

#include "tests/kit/refusal.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace opal;

namespace {

/// A wall seen from both sides, 0.1 m thick, along the x axis.
const Segment kUpper{{0, 0.1}, {4, 0.1}}, kLower{{4, 0}, {0, 0}};

}  // namespace

TEST_CASE("features within a radius are those that a walk over all features finds") {
  const auto walls = random_walls(300, 5);
  const MapView view(map_of(walls), "PlanarLidar2D");
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-5, 65), radius(0.1, 20);
  for (int query = 0; query < 100; ++query) {
    const Point p{place(random), place(random)};
    const double r = radius(random);
    std::vector<MapFeatureNumber> expected;
    for (std::size_t k = 0; k < walls.size(); ++k)
      if (distance_m(walls[k], p) <= r) expected.emplace_back(k);
    std::vector<MapFeatureNumber> found = view.within(p, r);
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
    const Point p{place(random), place(random)};
    double nearest = MapView::clearance_cap_m();
    for (const Geometry& wall : walls) nearest = std::min(nearest, distance_m(wall, p));
    CAPTURE(query, p.transpose());
    CHECK(std::abs(view.clearance_m(p) - nearest) < 0.08);
  }
}

TEST_CASE("of a thin wall's two faces, the one that faces the viewer is found") {
  const MapView view(map_of({kUpper, kLower}), "PlanarLidar2D");
  CHECK(view.nearest_facing({2, 0.05}, {0, -1}) == MapFeatureNumber(0));
  CHECK(view.nearest_facing({2, 0.05}, {0, 1}) == MapFeatureNumber(1));
  CHECK_FALSE(view.nearest_facing({2, 3}, {0, -1}).exists());
}

TEST_CASE("a ray finds the first wall it crosses, and says if it comes from behind") {
  const MapView view(map_of({kUpper, Segment{{0, -2}, {4, -2}}, Circle{{2, 3}, 0.3}}), "PlanarLidar2D");
  const auto from_above = view.first_crossing({1, 2}, {1, -3}, 0.2);
  CHECK(from_above.feature == MapFeatureNumber(0));
  CHECK(from_above.range_m == Approx(1.9).margin(0.01));
  CHECK_FALSE(from_above.from_behind);
  CHECK(view.first_crossing({1, -1}, {1, 1}, 0.2).from_behind);
  CHECK(view.first_crossing({2, 5}, {2, 1}, 0.2).feature == MapFeatureNumber(2));
  CHECK_FALSE(view.first_crossing({1, 2}, {1, 0.0}, 0.2).feature.exists());  // overshoots by less than the margin
  CHECK_FALSE(view.first_crossing({5, 2}, {5, -3}, 0.2).feature.exists());   // passes beside
  CHECK_FALSE(view.first_crossing({1, 2}, {1, 2}, 0.2).feature.exists());    // no way at all
}

TEST_CASE("faces that lie on one straight line and look the same way share its number, wherever the map lies") {
  for (const Pose2& moved : {Pose2(), Pose2(-40, 300, 0.4), Pose2(7, 7, 2.9)}) {
    std::vector<Geometry> geometries;
    const auto add = [&](const Point& begin, const Point& end) {
      geometries.push_back(Segment{moved * begin, moved * end});
    };
    add({0, 0}, {6, 0});
    add({7, 0.1}, {9, 0.1});    // the next piece
    add({9, -0.05}, {9.4, 0});  // a short one, hardly askew
    add({42, 0}, {43, 0});      // beyond 30 m
    add({6, -0.1}, {0, -0.1});  // the other side of the wall
    add({0, 0.6}, {6, 0.6});    // beside it
    add({6, 0}, {6, 3});        // across
    geometries.push_back(Circle{moved * Point(8, 0), 0.2});
    const MapView view(map_of(geometries), "PlanarLidar2D");
    std::vector<int> lines;
    for (std::size_t k = 0; k < geometries.size(); ++k)
      lines.push_back(view.surface(MapFeatureNumber(k)).line.number());
    CAPTURE(moved.x(), moved.y(), moved.heading_rad());
    CHECK(lines == std::vector<int>{0, 0, 0, 3, 4, 5, 6, 7});
  }
}

TEST_CASE("one line goes on as far as each piece follows the one before, in both directions") {
  for (const double turned_rad : {0.0, 0.7, -2.3}) {
    std::vector<Geometry> geometries;
    for (int k : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, -1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11})
      geometries.push_back(
          transformed(Pose2(3, 5, turned_rad), Segment{{25.0 * k, 0.01 * k}, {25.0 * k + 2, 0.01 * k}}));
    const MapView view(map_of(geometries), "PlanarLidar2D");
    for (MapFeatureNumber number : view.features()) {
      CAPTURE(turned_rad, number);
      CHECK(view.surface(number).line == view.surface(MapFeatureNumber(0)).line);
    }
  }
}

TEST_CASE("far outside the map there is nothing, whatever is asked") {
  const MapView view(map_of({kUpper}), "PlanarLidar2D");
  for (const Point& p : {Point(1e9, 1e9), Point(-1e9, 3), Point(std::nan(""), 0)}) {
    CHECK_FALSE(view.nearest_facing(p, {0, -1}).exists());
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
    const Point here{place(random), place(random)}, near(here + Point{step(random), step(random)});
    float sum = 0;
    for (const Point& point : points) sum += view.likelihood_field(here + point);
    CHECK(view.likelihood_field_sum(points, here) == Approx(sum));
    CHECK(view.coarse_likelihood_field_sum(points, here) >= sum - 1e-4f);
    CHECK(view.likelihood_field_sum(points, near, (near - here).norm() + kCellDiagonal_m) >= sum - 1e-4f);
  }
}

TEST_CASE("a sensor that perceives nothing of a map is refused by name") {
  CHECK_THROWS_WITH(MapView(map_of({kUpper}), "Camera"), "test: holds no feature that sensor 'Camera' can perceive");
}

TEST_CASE("a ray finds the nearer of two walls, however shallow it meets the other one") {
  const Segment shallow{{0, 0}, {4, 0.2}}, across{{1, 1}, {1, -1}};  // along y = 0.1 they are met at x = 2 and x = 1
  const std::vector<Geometry> walls =
      GENERATE_COPY(std::vector<Geometry>{shallow, across}, std::vector<Geometry>{across, shallow});
  const MapView view(map_of(walls), "PlanarLidar2D");
  const auto met = view.first_crossing({-1, 0.1}, {6, 0.1}, 0);
  REQUIRE(met.feature.exists());
  CHECK(met.range_m == Approx(2));
}

TEST_CASE("what a ray meets first is what a walk over all walls finds") {
  const auto walls = random_walls(60, 12);
  const MapView view(map_of(walls), "PlanarLidar2D");
  std::mt19937 random(13);
  std::uniform_real_distribution<double> place(-5, 65);
  int farther = 0, rays = 0;
  for (int ray = 0; ray < 2000; ++ray) {
    const Point from{place(random), place(random)}, to{place(random), place(random)};
    const auto met = view.first_crossing(from, to, 0);
    double least_m = std::numeric_limits<double>::infinity();
    for (const Geometry& wall : walls) {
      const auto& face = std::get<Segment>(wall);
      const Point normal = left_of(face.direction());
      const double slope = normal.dot((to - from).normalized());
      if (std::abs(slope) < 0.05) continue;
      const double range_m = normal.dot(face.begin - from) / slope;
      const double along_m = face.direction().dot(from + range_m * (to - from).normalized() - face.begin);
      if (range_m > 0.01 && range_m < (to - from).norm() - 0.01 && along_m > 0 && along_m < face.length_m())
        least_m = std::min(least_m, range_m);
    }
    if (std::isinf(least_m)) continue;
    ++rays;
    if (!met.feature.exists() || met.range_m > least_m + 0.01) ++farther;
  }
  CAPTURE(rays, farther);
  CHECK(farther <= rays / 100);  // a cell names two walls at most, and three may be near it
}

TEST_CASE("a feature that stands far from all others is named, and takes no memory") {
  const auto far = map_of({Segment{{0, 0}, {4, 0}}, Segment{{4, 0}, {4, 3}}, Segment{{2e5, 3e5}, {2e5 + 1, 3e5}}});
  CHECK_THAT(refused_with<MapError>([&] { MapView(far, "PlanarLidar2D"); }),
             Catch::Contains(far->features()[2].id + " is 360.6 km from the middle of the others"));
}
