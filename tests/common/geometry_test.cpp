#include <opal/common/geometry.hpp>

#include <catch2/catch.hpp>

#include <vector>

using namespace opal;

namespace {

/// The edges of a closed ring.
std::vector<Segment> ring_of(const std::vector<Point>& corners) {
  std::vector<Segment> edges;
  for (std::size_t k = 0; k < corners.size(); ++k) edges.push_back({corners[k], corners[(k + 1) % corners.size()]});
  return edges;
}

}  // namespace

TEST_CASE("angles go from radians to degrees and back") {
  CHECK(degrees(std::numbers::pi) == Approx(180));
  CHECK(radians(90) == Approx(std::numbers::pi / 2));
  CHECK(degrees(radians(-33)) == Approx(-33));
}

TEST_CASE("a point is within a ring and outside of its holes") {
  std::vector<Segment> edges = ring_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const std::vector<Segment> hole = ring_of({{4, 4}, {4, 6}, {6, 6}, {6, 4}});
  edges.insert(edges.end(), hole.begin(), hole.end());
  CHECK(is_within(edges, {1, 5}));
  CHECK(is_within(edges, {9, 5}));
  CHECK_FALSE(is_within(edges, {5, 5}));
  CHECK_FALSE(is_within(edges, {-1, 5}));
  CHECK_FALSE(is_within(edges, {11, 5}));
  CHECK_FALSE(is_within({}, {0, 0}));
}

TEST_CASE("a ray through a corner enters a ring once, and passes a tip twice") {
  const std::vector<Segment> diamond = ring_of({{0, -1}, {1, 0}, {0, 1}, {-1, 0}});
  CHECK(is_within(diamond, {0, 0}));
  CHECK_FALSE(is_within(diamond, {-2, 0}));
  CHECK_FALSE(is_within(diamond, {-2, 1}));
  CHECK_FALSE(is_within(diamond, {-2, -1}));
}
