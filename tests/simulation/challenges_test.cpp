#include "simulation/drives/challenges.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::simulation;

namespace {

Pose2 start_of(const Challenge& challenge, std::uint64_t seed) {
  static const auto map = SemanticMap::read(OPAL_SOURCE_DIR "/maps/atlas.jsonld");
  return drive(challenge, map, {}, 0.1, seed).recording.scans.front().T_map_base;
}

}  // namespace

TEST_CASE("each route of the thesis' challenges has a start and a heading of its own, the same for all seeds") {
  const std::vector<Challenge> all = thesis3_challenges();
  const Pose2 b1 = start_of(all[2], 1), b2 = start_of(all[3], 1), again = start_of(all[2], 2);
  CHECK(distance_m(b1, b2) > 0.1);
  CHECK(angle_between_rad(b1, b2) > 1e-3);
  CHECK(angle_between_rad(b1, again) == 0);
  double lowest = std::min(b1.y(), b2.y()), highest = std::max(b1.y(), b2.y());
  for (const std::size_t k : {4u, 5u, 6u}) {
    const double y = start_of(all[k], 1).y();
    lowest = std::min(lowest, y);
    highest = std::max(highest, y);
  }
  CHECK(highest - lowest > 20);  // of 41 m: not in one room
}
