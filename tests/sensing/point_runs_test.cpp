#include <opal/sensing/point_runs.hpp>

#include <catch2/catch.hpp>

using namespace opal;

namespace {

/// From `begin` on, each so far from the one before.
void append(std::vector<Point>& points, const Point& begin, const Point& step, int number) {
  for (int k = 0; k < number; ++k) points.push_back(begin + k * step);
}

}  // namespace

TEST_CASE("legs before a wall are runs of their own, and may walk; pieces of the wall stay what they are") {
  std::vector<Point> points;
  append(points, {4, -2}, {0, 0.05}, 30);  // the wall, to the right of the legs
  append(points, {2, -0.2}, {0, 0.03}, 4);
  append(points, {2.2, 0.3}, {0, 0.03}, 4);
  append(points, {4, 0.9}, {0, 0.05}, 30);
  const std::vector<PointRun> runs = point_runs(points);
  REQUIRE(runs.size() == 4);
  CHECK_FALSE(runs[0].may_walk);
  CHECK(runs[1].may_walk);
  CHECK(runs[2].may_walk);
  CHECK_FALSE(runs[3].may_walk);
  CHECK(runs[2].first == 34);
  CHECK(runs[2].end == 38);
}

TEST_CASE("runs follow each other without a gap, from the first point to the last") {
  std::vector<Point> points;
  for (int k = 0; k < 200; ++k) points.push_back((1 + (k * 7 % 13)) * unit_vector(0.03 * k));
  std::size_t next = 0;
  for (const PointRun& run : point_runs(points)) {
    CHECK(run.first == next);
    CHECK(run.end > run.first);
    next = run.end;
  }
  CHECK(next == points.size());
  CHECK(point_runs({}).empty());
}

TEST_CASE("sparse points of a far wall belong together") {
  std::vector<Point> points;
  append(points, {10, 3}, {0.7, 0}, 12);
  const std::vector<PointRun> runs = point_runs(points);
  REQUIRE(runs.size() == 1);
  CHECK_FALSE(runs[0].may_walk);
}
