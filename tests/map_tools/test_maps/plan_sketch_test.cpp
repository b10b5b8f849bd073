#include "map_tools/test_maps/plan_sketch.hpp"

#include "map_tools/test_maps/grid_smoothing.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

using namespace opal;

namespace {

using Cell = MapRaster::Cell;

/// 10 x 6 m with a corner at the origin; a wall of 0.2 m stands across it at x = 5, with a door of 1 m.
std::shared_ptr<const SemanticMap> two_rooms() {
  std::vector<MapFeature> features;
  const auto face = [&](const Point& begin, const Point& end) {
    features.push_back({"face-" + std::to_string(features.size()), MapObjectNumber(0), "opal:Wall", "PlanarLidar2D",
                        Segment{begin, end}});
  };
  face({0, 0}, {10, 0}), face({10, 0}, {10, 6}), face({10, 6}, {0, 6}), face({0, 6}, {0, 0});
  face({4.9, 0}, {4.9, 4}), face({5.1, 4}, {5.1, 0});
  features.push_back({"leaf", MapObjectNumber(1), "opal:Door", "", Segment{{5, 4}, {5, 5}}});
  return SemanticMap::make("two rooms", {{"walls", "opal:Wall"}, {"door", "opal:Door"}}, std::move(features));
}

/// By a steady hand, and true to scale.
PlanSketch exact() {
  PlanSketch sketch = drawn_by_hand();
  sketch.wobble_m = sketch.scale_sigma = sketch.furniture = sketch.words = 0;
  return sketch;
}

std::size_t ink_in(const MapRaster& raster, const Point& low, const Point& high) {
  std::size_t ink = 0;
  for (double x = low.x(); x < high.x(); x += raster.resolution_m)
    for (double y = low.y(); y < high.y(); y += raster.resolution_m) ink += raster.at({x, y}) == Cell::occupied;
  return ink;
}

/// How often ink begins along a way in the direction of x.
int lines_across(const MapRaster& raster, double from_x, double to_x, double y) {
  int lines = 0;
  bool was_ink = false;
  for (double x = from_x; x < to_x; x += 0.01) {
    const bool is_ink = raster.at({x, y}) == Cell::occupied;
    lines += is_ink && !was_ink;
    was_ink = is_ink;
  }
  return lines;
}

}  // namespace

TEST_CASE("a steady hand draws lines where walls are, on paper that is free everywhere else") {
  const MapRaster plan = sketched(*two_rooms(), exact());
  for (const double y : {0.5, 2.5, 5.5}) {
    CHECK(plan.at({0.01, y}) == Cell::occupied);
    CHECK(plan.at({9.99, y}) == Cell::occupied);
  }
  CHECK(ink_in(plan, {0.5, 0.5}, {3.8, 3}) == 0);
  CHECK(std::count(plan.cells.begin(), plan.cells.end(), Cell::unknown) == 0);
}

TEST_CASE("a wall of two faces is one line by hand, and two in print") {
  PlanSketch printed = exact();
  printed.single_lines = false;
  CHECK(lines_across(sketched(*two_rooms(), exact()), 4, 6, 2) == 1);
  CHECK(lines_across(sketched(*two_rooms(), printed), 4, 6, 2) == 2);
}

TEST_CASE("a door is a leaf out of its opening, with an arc") {
  const MapRaster plan = sketched(*two_rooms(), exact());
  CHECK(lines_across(plan, 4.9, 5.1, 4.5) == 0);  // the opening
  const std::size_t left = ink_in(plan, {3.8, 3.9}, {4.9, 5.2}), right = ink_in(plan, {5.1, 3.9}, {6.2, 5.2});
  CHECK(std::max(left, right) > 40);
  CHECK(std::min(left, right) < 5);
}

TEST_CASE("furniture and words are ink, more of them are more") {
  const auto ink = [](double furniture, double words) {
    PlanSketch sketch = exact();
    sketch.furniture = furniture;
    sketch.words = words;
    const MapRaster plan = sketched(*two_rooms(), sketch);
    return std::count(plan.cells.begin(), plan.cells.end(), Cell::occupied);
  };
  CHECK(ink(10, 0) > ink(0, 0));
  CHECK(ink(0, 10) > ink(0, 0));
  CHECK(ink(20, 20) > ink(5, 5));
}

TEST_CASE("the same seed draws the same plan, another seed another one") {
  PlanSketch sketch = GENERATE(drawn_by_hand(), printed_and_scanned());
  const MapRaster first = sketched(*two_rooms(), sketch), again = sketched(*two_rooms(), sketch);
  CHECK(first.cells == again.cells);
  sketch.seed = 2;
  CHECK(sketched(*two_rooms(), sketch).cells != first.cells);
}

TEST_CASE("an error of scale stretches the plan about its middle") {
  PlanSketch sketch = exact();
  sketch.scale_sigma = 0.1;
  const MapRaster plan = sketched(*two_rooms(), sketch);
  const auto edge = [&](double from_x, double step_m) {
    double x = from_x;
    while (plan.at({x, 2.5}) != Cell::occupied && std::abs(x) < 30) x += step_m;
    return x;
  };
  const double left = edge(3, -0.01), right = edge(7, 0.01);
  CHECK(0.5 * (left + right) == Approx(5).margin(0.06));
  CHECK(std::abs(right - left - 10) > 0.1);
}

TEST_CASE("numbers that make no sense are refused by name") {
  PlanSketch sketch;
  sketch.wobble_m = GENERATE(-1.0, std::numeric_limits<double>::quiet_NaN(), 1e9);
  CHECK_THROWS_WITH(sketched(*two_rooms(), sketch), Catch::Contains("plan sketch: wobble"));
  sketch = {};
  sketch.resolution_m = 0;
  CHECK_THROWS_AS(sketched(*two_rooms(), sketch), ConfigError);
}

TEST_CASE("a map without a surface has no plan") {
  CHECK_THROWS_AS(sketched(*SemanticMap::make("empty", {}, {}), drawn_by_hand()), MapError);
}

TEST_CASE("smoothing spreads a number over its neighbours, and keeps the sum") {
  std::vector<double> values(21 * 21, 0);
  values[10 * 21 + 10] = 1;
  smooth_grid(values, 21, 21, 1.5);
  CHECK(std::accumulate(values.begin(), values.end(), 0.0) == Approx(1).epsilon(1e-3));
  CHECK(values[10 * 21 + 11] == Approx(values[11 * 21 + 10]));
  CHECK(values[10 * 21 + 10] < 0.1);
  const std::vector<double> before = values;
  smooth_grid(values, 21, 21, 0);
  CHECK(values == before);
}
