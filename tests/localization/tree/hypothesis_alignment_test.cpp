#include "tests/localization/synthetic_scene.hpp"
#include "tests/localization/tree/deaf_listener.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::synthetic;

namespace {

const Pose2 kStart(4, 4.5, 0.3);

/// A robot in the room, and one hypothesis, that is right.
struct Found {
  Found() {
    std::vector<VerifiedCandidate> candidates(1);
    candidates.front().candidate.T_map_base = kStart;
    set.spawn(std::move(candidates), robot.observation(), 1, past);
  }
  Pose2 T_map_base() const { return set.alive().at(0).hypothesis.T_map_local * robot.local_map().T_local_base(); }
  std::shared_ptr<const MapView> map = view_of(room());
  Judges judges{map, {{"alike", constant_scorer(1), ScorerRole::decides, 1}}};
  Robot robot{map, kStart};
  RetrospectiveVerification past{map, judges.ensemble, no_earlier_scans(), 1};
  DeafListener listener;
  HypothesisSet set{map, judges.ensemble, {}, listener};
};

}  // namespace

TEST_CASE("who sees nothing stays where dead reckoning is, however little that is trusted") {
  Found found;
  const Pose2 next = kStart * Pose2(0.5, 0.1, 0.2);
  found.robot.drive_blind_to(next);
  const std::vector<Point> coarse{{1, 0}, {2, 0}};
  found.set.track(found.robot.observation(), 1, coarse, {0.5, 0.3});
  CHECK(distance_m(found.T_map_base(), next) < 1e-9);
  CHECK(angle_between_rad(found.T_map_base(), next) < 1e-9);
}

TEST_CASE("who sees walls while dead reckoning is trusted is where both agree, and known ever better") {
  Found found;
  std::vector<double> variances;
  for (int k = 1; k <= 4; ++k) {
    const Pose2 next = kStart * Pose2(0.3 * k, 0, 0);
    found.robot.drive_to(next);
    found.set.track(found.robot.observation(), 1, {}, {0, 0});
    CHECK(distance_m(found.T_map_base(), next) < 0.02);
    variances.push_back(found.set.alive().at(0).pose.covariance().trace());
  }
  CHECK(variances.back() < 0.8 * variances.front());
}
