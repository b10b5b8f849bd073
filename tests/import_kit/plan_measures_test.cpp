#include <opal/import_kit/first_ids.hpp>
#include <opal/import_kit/mean_thickness.hpp>

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("the mean thickness of something long is about its thickness, whichever way round it is drawn") {
  const std::vector<Point> strip{{0, 0}, {10, 0}, {10, 0.2}, {0, 0.2}};
  const std::vector<Point> reversed(strip.rbegin(), strip.rend());
  CHECK(mean_thickness_m({&strip, 1}) == Approx(2 * 2 / 20.4));
  CHECK(mean_thickness_m({&reversed, 1}) == Approx(mean_thickness_m({&strip, 1})));
}

TEST_CASE("walls around a room are as thick as they are, not as the room is wide") {
  const std::vector<std::vector<Point>> walls{{{0, 0}, {10, 0}, {10, 10}, {0, 10}},
                                              {{0.2, 0.2}, {9.8, 0.2}, {9.8, 9.8}, {0.2, 9.8}}};
  CHECK(mean_thickness_m(walls) == Approx(0.2));
  CHECK(mean_thickness_m({walls.data(), 1}) == Approx(5));
  CHECK(mean_thickness_m({}) == 0);
}

TEST_CASE("of many ids a report names five") {
  CHECK(first_of(std::vector<std::string>{}).empty());
  CHECK(first_of(std::vector<std::string>{"a", "b"}) == "a, b");
  CHECK(first_of(std::vector<std::string>{"a", "b", "c", "d", "e"}) == "a, b, c, d, e");
  CHECK(first_of(std::vector<std::string>{"a", "b", "c", "d", "e", "f"}) == "a, b, c, d, e, ...");
}
