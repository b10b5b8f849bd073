#include "tests/localization/driven_robot.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// Localized, and standing at x = 2 m.
struct Found {
  Pose2 truth;
  Driven robot{std::make_shared<ToldScorer>([this](const Hypothesis& hypothesis, const Observation& seen) {
    return Score{distance_m(seen.T_map_base(hypothesis.T_map_local), truth) < 1 ? 5. : -5., {}, {}};
  })};

  Found() {
    for (int k = 30; k >= 0; --k) drive_to(2 + 0.2 * k);
  }
  Status drive_to(double x_m) {
    truth = Pose2(x_m, 4.5, 0.1);
    return robot.drive_to(truth).value().status;
  }
};

}  // namespace

TEST_CASE("after a long way without scans, a robot is localized by new evidence only") {
  const double way_m = GENERATE(3., 4., 6.);
  CAPTURE(way_m);
  Found found;
  CHECK(found.drive_to(2 + way_m) == Status::searching);
  CHECK_THAT(found.robot.localizer.why(), Catch::Contains("broke off from those before"));
  const double weight = StatusOptions().localized_weight;
  int scans = 1;
  while (found.drive_to(2 + way_m - 0.2 * scans) != Status::localized && scans < 100) ++scans;
  CHECK(scans * 0.2 > 0.5 * weight * TemperingOptions().distance_m);
  CHECK(scans < 100);
}

TEST_CASE("a short way without scans is as good as any") {
  const double way_m = GENERATE(0.2, 1., 2.);
  CAPTURE(way_m);
  Found found;
  CHECK(found.drive_to(2 + way_m) == Status::localized);
}
