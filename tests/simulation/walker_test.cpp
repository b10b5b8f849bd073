#include "simulation/walker.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::simulation;

namespace {

/// A corridor in which nobody can pass a robot that stands in the middle.
std::shared_ptr<const SemanticMap> corridor() {
  const Point corners[] = {{0, 0}, {20, 0}, {20, 1.7}, {0, 1.7}};
  std::vector<MapFeature> features;
  for (int k = 0; k < 4; ++k)
    features.push_back({"face-" + std::to_string(k), MapObjectNumber(0), "opal:Wall", "PlanarLidar2D",
                        Segment{corners[k], corners[(k + 1) % 4]}});
  return SemanticMap::make("corridor", {{"wall", "opal:Wall"}}, std::move(features));
}

double space_m(const Walker& walker, const Circle& robot) {
  const auto legs = walker.legs();
  const auto to = [&](const Circle& leg) { return (leg.center - robot.center).norm() - leg.radius_m - robot.radius_m; };
  return std::min(to(legs[0]), to(legs[1]));
}

}  // namespace

TEST_CASE("whoever meets a robot turns round in some seconds, and does not touch it") {
  constexpr double kStep_s = 0.05, kClose_m = 0.4, kLongest_s = 60;  // several pauses of 10 s at most
  const std::uint64_t seed = GENERATE(range(1, 21));
  CAPTURE(seed);
  const auto map = corridor();
  const Floor floor(*map, RayCaster({{map->features()[0].geometry}, {map->features()[2].geometry}}), 0.4);
  Walker walker(floor, Random(seed));
  const bool is_right = walker.position().x() > 10;
  const Circle robot{{walker.position().x() + (is_right ? -2 : 2), 0.85}, 0.3};
  double close_s = 0, longest_s = 0, least_m = 10;
  for (double now_s = 0; now_s < 600; now_s += kStep_s) {
    walker.walk(kStep_s, floor, robot);
    close_s = space_m(walker, robot) < kClose_m ? close_s + kStep_s : 0;
    longest_s = std::max(longest_s, close_s);
    least_m = std::min(least_m, space_m(walker, robot));
  }
  CHECK(longest_s < kLongest_s);
  CHECK(least_m > 0);
}
