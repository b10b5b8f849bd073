#include "localization/decision/unmapped_walls.hpp"

#include "tests/localization/synthetic_scene.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// What a robot has seen of these walls from so many places; its local frame is the map's.
double unmapped_m(const Features& seen, int places = 6, const Pose2& T_map_local = {}) {
  static const std::shared_ptr<const MapView> map = view_of(room());
  LocalMapOptions options;
  options.optimize_every = 0;
  LocalMap local_map(options, nullptr);
  for (int k = 0; k < places; ++k) {
    const Pose2 T_local_base(0, 0.2 * k, 0);
    local_map.add(sample_of({}, T_local_base), moved(T_local_base.inverse(), moved(T_map_local.inverse(), seen)));
  }
  return unmapped_walls_m(local_map, *map, T_map_local);
}

}  // namespace

TEST_CASE("a wall that the map has is not unmapped, wherever the local frame lies") {
  CHECK(unmapped_m({seen_wall({1, 0}, {6, 0})}) == 0);
  CHECK(unmapped_m({seen_wall({1, 0}, {6, 0})}, 6, Pose2(3, -2, 1)) == 0);
  CHECK(unmapped_m({seen_wall({1, 0.2}, {6, 0.2})}) == 0);  // it may be off by a little
}

TEST_CASE("walls that the map lacks count in full, and add up") {
  CHECK(unmapped_m({seen_wall({4, 5}, {8, 5})}) == Approx(4));
  CHECK(unmapped_m({seen_wall({4, 5}, {8, 5}), seen_wall({5, 1}, {5, 4})}) == Approx(7));
  CHECK(unmapped_m({seen_wall({4, 5}, {8, 5})}, 6, Pose2(3, -2, 1)) == Approx(4));
}

TEST_CASE("of a wall that the map has in part, the rest counts, whichever end it is") {
  // Beyond the corner at x = 10 a wall is within 0.3 m of the map for 0.3 m.
  CHECK(unmapped_m({seen_wall({8, 0}, {13, 0})}) == Approx(2.7).margin(0.11));
  CHECK(unmapped_m({seen_wall({13, 0}, {8, 0})}) == Approx(2.7).margin(0.11));
  CHECK(unmapped_m({seen_wall({7.45, 0}, {10.45, 0})}) == Approx(0.2).margin(0.11));
  CHECK(unmapped_m({seen_wall({10.45, 0}, {7.45, 0})}) == Approx(0.2).margin(0.11));
}

TEST_CASE("what is short, not seen often enough, or no wall says nothing of the map") {
  CHECK(unmapped_m({seen_wall({4, 5}, {6.4, 5})}) == 0);
  CHECK(unmapped_m({seen_wall({4, 5}, {6.6, 5})}) == Approx(2.6));
  CHECK(unmapped_m({seen_wall({4, 5}, {8, 5})}, 1) == 0);
  CHECK(unmapped_m({{"opal:Column", Circle{{6, 5}, 0.4}}}) == 0);
}
