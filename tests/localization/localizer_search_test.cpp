// What the pipeline as a whole asks of the search.
#include "tests/localization/driven_robot.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// The room's lower wall, as the laser sees it.
Feature wall_ahead(const Pose2& T_map_base) {
  Feature wall = transformed((T_map_base * T_base_laser).inverse(), Feature{"opal:Wall", Segment{{1, 0}, {9, 0}}});
  wall.support_m = 8;
  return wall;
}

}  // namespace

TEST_CASE("until a place is called localized, the map is searched by walls where nothing else is seen") {
  LocalizerOptions options;
  options.search.under_constrained_until_nat = -1e9;  // the first hypothesis has gathered enough
  for (const double weight : {1e9, 0.1}) {
    options.status.localized_weight = weight;
    Pose2 truth;
    Driven scene;
    LocalizerParts parts =
        scene.parts(std::make_shared<ToldScorer>([&](const Hypothesis& one, const Observation& seen) {
                      const double off_m = distance_m(seen.T_map_base(one.T_map_local), truth);
                      return Score{off_m < 1 ? 5. : -5., {}, {}};
                    }),
                    options);
    parts.patterns.push_back({"wall", std::make_shared<WallTemplate>()});
    Heard heard;
    Localizer localizer(std::move(parts), &heard);
    for (int k = 0; k < 30; ++k) {
      truth = Pose2(2 + 0.2 * k, 4.5, 0.1);
      scene.detector->features = detected_from(*scene.map, truth);
      if (k > 12) scene.detector->features = {wall_ahead(truth)};
      localizer.update(sample_of(scan_from(*scene.map, truth), truth, T_base_laser));
    }
    const bool is_localized = heard.of("estimate").back()["status"] == "localized";
    CHECK(is_localized == (weight < 1));
    CHECK(heard.of("searched").back()["patterns"].empty() == is_localized);
  }
}
