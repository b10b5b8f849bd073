#include "made_drives.hpp"

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("a long face that is seen piece by piece is one face") {
  const auto map = made::room();
  const MapView view(map, made::kSensor);
  std::vector<KeyframeView> views(8);
  for (int k = 0; k < 8; ++k)
    views[static_cast<std::size_t>(k)].faces = {{Segment{{1.0 + 0.6 * k, 3}, {2.8 + 0.6 * k, 3}}}};
  const std::vector<Pose2> poses(8);
  const auto faces = unmapped_faces(view, MapBelief(map->features().size()), views, poses);
  REQUIRE(faces.size() == 1);
  CHECK(faces.front().views == 8);
  CHECK(faces.front().face.length_m() > 3);
}

TEST_CASE("the other side of a mapped wall is another face") {
  const auto map = made::room();
  const MapView view(map, made::kSensor);
  const std::vector<Pose2> poses(5);
  const MapBelief belief(map->features().size());
  const Segment inside{{2, 0.1}, {5, 0.1}}, outside{{5, -0.15}, {2, -0.15}};  // wall-0 is seen from y > 0
  CHECK(unmapped_faces(view, belief, std::vector<KeyframeView>(5, {{{inside}}, {}, {}}), poses).empty());
  const auto found = unmapped_faces(view, belief, std::vector<KeyframeView>(5, {{{outside}}, {}, {}}), poses);
  REQUIRE(found.size() == 1);
  CHECK(found.front().face.length_m() > 2.5);
}

TEST_CASE("three keyframes show a face, two do not") {
  const auto map = made::room();
  const MapView view(map, made::kSensor);
  const MapBelief belief(map->features().size());
  for (const std::size_t count : {2, 3}) {
    const std::vector<KeyframeView> views(count, {{{Segment{{2, 3}, {5, 3}}}}, {}, {}});
    CHECK(unmapped_faces(view, belief, views, std::vector<Pose2>(count)).size() == (count == 3 ? 1 : 0));
  }
}
