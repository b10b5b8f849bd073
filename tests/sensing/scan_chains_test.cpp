// Laws of the cutting of scans into surfaces. What is cut where: lines/line_extraction_test.cpp.
#include <opal/sensing/scan_chains.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

using namespace opal;

namespace {

constexpr int kBeams = 360;
constexpr double kStep_rad = 2 * std::numbers::pi / kBeams;

/// What a laser that sees all round has on each beam: a range, 0 for nothing, a negative one for a free beam. Bearings
/// lie off those of the limits, so that rounding never changes their order.
Scan round_scan(const std::vector<double>& ranges_m, int turned = 0) {
  Scan scan;
  scan.angle_increment_rad = kStep_rad;
  scan.range_max_m = 30;
  for (int beam = 0; beam < kBeams; ++beam) {
    const double range_m = ranges_m[static_cast<std::size_t>((beam + turned) % kBeams)];
    const double bearing = -std::numbers::pi + (beam + 0.25) * kStep_rad;
    if (range_m < 0) scan.free_bearings_rad.push_back(bearing);
    if (range_m > 0)
      scan.points.push_back({range_m * unit_vector(bearing), range_m, bearing, (beam + turned) % kBeams});
  }
  return scan;
}

/// A wall all round with a gap, a free gap, posts before it, and something farther away.
std::vector<double> room() {
  std::vector<double> ranges(kBeams, 3);
  std::fill(ranges.begin() + 40, ranges.begin() + 70, 0);
  std::fill(ranges.begin() + 120, ranges.begin() + 140, -1);
  std::fill(ranges.begin() + 200, ranges.begin() + 230, 5);
  for (int beam = 260; beam < 290; beam += 3) ranges[static_cast<std::size_t>(beam)] = 2;
  return ranges;
}

/// The beams of each surface, surface after surface.
std::vector<std::vector<int>> surfaces(const ScanChains& chains) {
  std::vector<std::vector<int>> all;
  for (const Run& chain : chains.chains) {
    all.emplace_back();
    for (int hit = chain.first; hit <= chain.last; ++hit) all.back().push_back(chains.hits[hit].beam);
  }
  return all;
}

}  // namespace

TEST_CASE("a laser that sees all round has the same surfaces, wherever it begins") {
  const ScanChains chains = chained(round_scan(room()), {});
  CHECK(chains.full_circle);
  CHECK_FALSE(chains.closed);
  const auto expected = surfaces(chains);
  REQUIRE(expected.size() >= 5);
  for (const int turned : {1, 50, 90, 130, 215, 261, 262, 275, 359}) {
    CAPTURE(turned);
    CHECK(surfaces(chained(round_scan(room(), turned), {})) == expected);
  }
}

TEST_CASE("an outline that is closed begins at its farthest hit, wherever the laser begins") {
  std::vector<double> ranges;
  for (int beam = 0; beam < kBeams; ++beam) ranges.push_back(3 + 0.5 * std::cos((beam - 77) * kStep_rad));
  for (const int turned : {0, 30, 200}) {
    const ScanChains chains = chained(round_scan(ranges, turned), {});
    CHECK(chains.closed);
    REQUIRE(chains.chains.size() == 1);
    CHECK(chains.hits.front().beam == 77);
    CHECK(chains.hits.back().beam == 76);
  }
}

TEST_CASE("every usable hit is in one surface, and keeps its place among the beams") {
  const ScanChains chains = chained(round_scan(room()), {});
  std::map<int, int> times;
  int next = 0;
  for (std::size_t c = 0; c < chains.chains.size(); ++c) {
    CHECK(chains.chains[c].first == next);
    next = chains.chains[c].last + 1;
    for (int hit = chains.chains[c].first; hit <= chains.chains[c].last; ++hit) {
      CHECK(chains.chain_of[hit] == static_cast<int>(c));
      const Sightline& beam = chains.sightlines[chains.sightline_of[hit]];
      CHECK(beam.range_m == chains.hits[hit].range_m);
      CHECK((beam.range_m * beam.direction - chains.hits[hit].position).norm() < 1e-9);
      if (hit > chains.chains[c].first) CHECK(chains.sightline_of[hit] > chains.sightline_of[hit - 1]);
      ++times[chains.hits[hit].beam];
    }
  }
  const auto ranges = room();
  CHECK(next == std::count_if(ranges.begin(), ranges.end(), [](double range_m) { return range_m > 0; }));
  CHECK(std::all_of(times.begin(), times.end(), [](const auto& each) { return each.second == 1; }));
}

TEST_CASE("beams follow each other counter-clockwise, the free ones where they are, once around") {
  for (const int turned : {0, 100, 130, 300}) {
    const ScanChains chains = chained(round_scan(room(), turned), {});
    REQUIRE(chains.sightlines.size() == kBeams - 30);
    double turned_rad = 0;
    int free = 0;
    for (std::size_t k = 0; k < chains.sightlines.size(); ++k) {
      const Point& now = chains.sightlines[k].direction;
      const Point& next = chains.sightlines[(k + 1) % chains.sightlines.size()].direction;
      const double turn_rad = std::atan2(cross(now, next), now.dot(next));
      CHECK(turn_rad > 0);
      turned_rad += turn_rad;
      free += std::isinf(chains.sightlines[k].range_m) ? 1 : 0;
    }
    CHECK(turned_rad == Approx(2 * std::numbers::pi));
    CHECK(free == 20);
  }
}

TEST_CASE("neighbours of one surface may be farther apart the farther away the nearer of them is") {
  const auto is_one = [](double nearer_m, double step_m) {
    std::vector<double> ranges(kBeams, 0);
    for (std::size_t beam = 10; beam < 20; ++beam) ranges[beam] = nearer_m + (beam < 15 ? 0 : step_m);
    return chained(round_scan(ranges), {}).chains.size() == 1;
  };
  // 0.25 m, and eight spacings of two beams: 0.14 m at 1 m, 1.4 m at 10 m.
  CHECK(is_one(1, 0.37));
  CHECK_FALSE(is_one(1, 0.41));
  CHECK(is_one(10, 1.6));
  CHECK_FALSE(is_one(10, 1.7));
}

TEST_CASE("a hit goes on with the nearest of the surfaces that ended a few beams before, whichever ended last") {
  for (const std::size_t near_one : {0U, 1U}) {
    std::vector<double> ranges(kBeams, 0);
    for (std::size_t beam = 10; beam < 20; ++beam) ranges[beam] = beam % 2 == near_one ? 2 : 3;
    ranges[20] = 2.45;  // it may belong to either
    const auto all = surfaces(chained(round_scan(ranges), {}));
    REQUIRE(all.size() == 2);
    CHECK(all[near_one].size() == 6);
    CHECK(all[near_one].back() == 20);
  }
}

TEST_CASE("a neighbouring beam is known up to as many missing ones as a surface may lack, on either side") {
  std::vector<double> ranges(kBeams, 0);
  for (std::size_t beam : {50U, 51U, 55U, 60U}) ranges[beam] = 2;
  const ScanChains chains = chained(round_scan(ranges), {});
  REQUIRE(chains.hits.size() == 4);
  REQUIRE(chains.hits[1].beam == 51);
  REQUIRE(neighbour(chains, 1, -1));
  CHECK(neighbour(chains, 1, -1)->range_m == 2);
  CHECK(neighbour(chains, 1, 1));  // three are missing
  CHECK(neighbour(chains, 2, -1));
  CHECK_FALSE(neighbour(chains, 2, 1));  // four are
  CHECK_FALSE(neighbour(chains, 3, -1));
  CHECK_FALSE(neighbour(chains, 0, -1));
}
