#include "viewer/encoding/thinned_path.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

std::size_t points_of(const ThinnedPath& path) {
  std::size_t points = 0;
  for (const auto& line : path.lines()) points += line.size();
  return points;
}

}  // namespace

TEST_CASE("a path of a long drive has few points, and still leads from its beginning to the newest place") {
  ThinnedPath path(100);
  for (int k = 0; k <= 100'000; ++k) {
    path.add({0.05 * k, 0});
    REQUIRE(points_of(path) <= 100);
  }
  REQUIRE(path.lines().size() == 1);
  CHECK(path.lines()[0].front() == Point(0, 0));
  CHECK(path.lines()[0].back().x() == Approx(5000));
  CHECK(points_of(path) > 25);
}

TEST_CASE("a place that jumps begins a new line") {
  ThinnedPath path;
  for (const double x : {0.0, 0.5, 5.0, 5.2}) path.add({x, 0});
  REQUIRE(path.lines().size() == 2);
  CHECK(path.lines()[1].front().x() == 5);
}

TEST_CASE("a robot that stands adds no points") {
  ThinnedPath path;
  for (int k = 0; k < 1000; ++k) path.add({0.001 * (k % 3), 0});
  CHECK(points_of(path) <= 2);
}

TEST_CASE("where the estimate jumps again and again, the oldest lines go") {
  ThinnedPath path(100);
  for (int k = 0; k < 10'000; ++k) {
    path.add({10.0 * (k % 2), 0.001 * k});
    REQUIRE(points_of(path) <= 100);
  }
  CHECK(path.lines().back().back().y() == Approx(9.999));
}
