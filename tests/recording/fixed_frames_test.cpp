#include "recording/fixed_frames.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace opal::recording;

Transform link_at(const std::string& parent, const std::string& child, double x_m) {
  Transform transform;
  transform.parent = parent;
  transform.child = child;
  transform.T_parent_child.translation().x() = x_m;
  return transform;
}

}  // namespace

TEST_CASE("a transform on a moving topic that stands still fixes its frames, and one that moves does not") {
  SeenTransforms seen;
  for (const double x_m : {0.0, 0.5}) {
    seen.add(link_at("odom", "base", x_m), "/tf", false);
    seen.add(link_at("/base", "mast", 1), "/tf", false);
  }
  seen.add(link_at("mast", "/laser", 2), "/tf_static", true);
  const FixedFrames frames = seen.fixed_frames();
  REQUIRE(frames.pose("base", "laser"));
  CHECK(frames.pose("base", "laser")->translation().x() == 3);
  CHECK_FALSE(frames.pose("odom", "laser"));
  CHECK(seen.by_link().at({"odom", "base"}).moves);
  CHECK(seen.by_link().at({"odom", "base"}).messages == 2);
}

TEST_CASE("of two transforms to a frame the static one holds") {
  SeenTransforms seen;
  seen.add(link_at("base", "laser", 1), "/tf", false);
  seen.add(link_at("body", "laser", 2), "/tf_static", true);
  CHECK(seen.fixed_frames().pose("body", "laser"));
  CHECK_FALSE(seen.fixed_frames().pose("base", "laser"));
}
