#include "localization/events/run_events.hpp"
#include "tests/localization/synthetic_scene.hpp"

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("a map is written with all objects, and the shape of every feature") {
  const synthetic::Features features = synthetic::room();
  const auto event = map_event(*synthetic::view_of(features));
  CHECK(event["event"] == "map");
  CHECK(event["objects"].size() == features.size());
  REQUIRE(event["features"].size() == features.size());
  for (std::size_t k = 0; k < features.size(); ++k) {
    const auto& feature = event["features"][k];
    CAPTURE(feature.dump());
    CHECK(feature["type"] == features[k].type);
    CHECK(feature["perceivable"] == true);
    CHECK(feature.size() == 5);  // id, object, type, perceivable, and the geometry
  }
  CHECK(event["features"][0]["circle"] == nlohmann::ordered_json::array({3.0, 2.2, 0.4}));
  CHECK(event["features"][1]["segment"] == nlohmann::ordered_json::array({0.0, 0.0, 10.0, 0.0}));
}
