#include "made_drives.hpp"

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("a long face that is seen piece by piece is one face") {
  const auto map = made::room();
  const MapView view(map, made::kSensor);
  std::vector<KeyframeView> views(8);
  for (int k = 0; k < 8; ++k)
    views[static_cast<std::size_t>(k)].faces = {Segment{{1.0 + 0.6 * k, 3}, {2.8 + 0.6 * k, 3}}};
  const std::vector<Pose2> poses(8);
  const auto faces = unmapped_faces(view, MapBelief(map->features().size()), views, poses);
  REQUIRE(faces.size() == 1);
  CHECK(faces.front().views == 8);
  CHECK(faces.front().face.length_m() > 3);
}
