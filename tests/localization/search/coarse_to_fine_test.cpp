#include "localization/search/coarse_to_fine.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;

namespace {

/// A wall along x through the origin, along which its pattern may sweep, or not.
PatternInstance wall_pattern(double extent_m) {
  PatternInstance pattern;
  pattern.extent_min_m = -extent_m;
  pattern.extent_max_m = extent_m;
  return pattern;
}

/// Points on the wall, and as many 2 m beside it.
std::vector<Point> on_and_beside(int each) {
  std::vector<Point> points;
  for (int k = 0; k < each; ++k) points.insert(points.end(), {{0.3 * k, 0.1}, {0.3 * k, 2}});
  return points;
}

bool is_on_wall(const Point& point) { return point.y() < 0.3; }

}  // namespace

TEST_CASE("points along which a pattern sweeps come last, and none is lost") {
  const TellingPoints sweeping(wall_pattern(1), on_and_beside(15)), fixed(wall_pattern(0), on_and_beside(15));
  CHECK(sweeping.size() == 30);
  CHECK(fixed.size() == 30);
  const auto first_sweeping = sweeping.first(), first_fixed = fixed.first();
  CHECK(std::none_of(first_sweeping.begin(), first_sweeping.end(), is_on_wall));
  CHECK(std::any_of(first_fixed.begin(), first_fixed.end(), is_on_wall));
}

TEST_CASE("fewer than twenty points tell nothing") {
  CHECK(TellingPoints(wall_pattern(0), on_and_beside(10)).enough());
  CHECK_FALSE(TellingPoints(wall_pattern(0), on_and_beside(9)).enough());
}

TEST_CASE("the first points are spread over the scan") {
  std::vector<Point> points;
  for (int k = 0; k < 50; ++k) points.emplace_back(k, 5);
  const auto first = TellingPoints(wall_pattern(0), points).first();
  for (std::size_t k = 0; k < first.size(); ++k) CHECK(first[k].x() == 5. * static_cast<double>(k));
}

TEST_CASE("as long as few values have come all pass, then about the best share") {
  BestShare filter(10, 4);
  for (int k = 0; k < 10; ++k) CHECK(filter.passes(0.5f - 0.01f * static_cast<float>(k)));
  int passed = 0;
  for (int k = 0; k < 4000; ++k) passed += filter.passes(static_cast<float>(k * 37 % 101) / 100);
  CHECK(passed > 900);
  CHECK(passed < 1300);
  CHECK(filter.bar() == Approx(0.75).margin(0.03));
  CHECK(filter.passes(1));
  CHECK_FALSE(filter.passes(0.5f));
}

TEST_CASE("however many are perfect, the perfect pass") {
  BestShare filter(2, 1000);
  for (int k = 0; k < 100; ++k) REQUIRE(filter.passes(1));
  CHECK(filter.bar() <= 1);
  CHECK_FALSE(filter.passes(0.9f));
}
