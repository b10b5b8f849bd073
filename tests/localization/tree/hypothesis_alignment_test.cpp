#include "localization/alignment/coarse_points.hpp"
#include "tests/localization/synthetic_scene.hpp"
#include "tests/localization/tree/deaf_listener.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>

using namespace opal;
using namespace opal::synthetic;

namespace {

const Pose2 kStart(4, 4.5, 0.3);

/// A robot in the room, and one hypothesis, that is right, or off by so much.
struct Found {
  explicit Found(const Pose2& off = {}, std::shared_ptr<const MapView> in = view_of(room())) : map(std::move(in)) {
    std::vector<VerifiedCandidate> candidates(1);
    candidates.front().candidate.T_map_base = kStart * off;
    set.spawn(std::move(candidates), robot.observation(), 1, past);
  }
  Pose2 T_map_base() const { return set.alive().at(0).hypothesis.T_map_local * robot.local_map().T_local_base(); }
  std::shared_ptr<const MapView> map;
  std::vector<Pose2> judged_at;  ///< where scans were scored
  std::function<double(const Pose2&)> nat_at = [](const Pose2&) { return 1; };
  std::shared_ptr<const HypothesisScorer> alike =
      std::make_shared<ToldScorer>([this](const Hypothesis& hypothesis, const Observation& seen) {
        judged_at.push_back(seen.T_map_base(hypothesis.T_map_local));
        return Score{nat_at(judged_at.back()), {}, {}};
      });
  Judges judges{map, {{"alike", alike, ScorerRole::decides, 1}}};
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

TEST_CASE("a scan is scored where it fits best, and not where dead reckoning has the robot") {
  Found found(Pose2(0.15, -0.1, 0.05));
  found.robot.drive_to(kStart);
  found.judged_at.clear();
  found.set.track(found.robot.observation(), 1, {}, {0, 0});
  REQUIRE(found.judged_at.size() == 1);
  CHECK(distance_m(found.judged_at[0], kStart) < 0.03);
  CHECK(angle_between_rad(found.judged_at[0], kStart) < 0.01);
}

TEST_CASE("where all poses fit alike, a search leaves a hypothesis where dead reckoning has it") {
  Found found;
  found.robot.drive_to(kStart);
  const std::vector<Point> beyond_the_map{{300, 0}, {300, 1}};
  found.set.track(found.robot.observation(), 1, beyond_the_map, {0.4, 0.3});
  CHECK(distance_m(found.judged_at.back(), kStart) < 0.02);
  CHECK(angle_between_rad(found.judged_at.back(), kStart) < 0.01);
}

TEST_CASE("where dead reckoning has failed, what was known of the pose goes with it") {
  Found trusted, failed;
  for (int k = 1; k <= 8; ++k) {
    const Pose2 next = kStart * Pose2(0.3 * k, 0, 0);
    for (Found* found : {&trusted, &failed}) {
      found->robot.drive_to(next);
      const bool fails = found == &failed && k == 8;
      const std::vector<Point> coarse = coarse_points(found->robot.sample());
      found->set.track(found->robot.observation(), 1, coarse,
                       fails ? Eigen::Vector2d(0.3, 0.1) : Eigen::Vector2d(0, 0));
    }
  }
  const auto known_of = [](const Found& found) { return found.set.alive().at(0).pose.covariance().trace(); };
  CHECK(known_of(failed) > 1.2 * known_of(trusted));
}

TEST_CASE("where dead reckoning has failed, the best one of many hypotheses is found again") {
  Found found(Pose2(0.35, 0, 0.2));
  for (int k = 1; k < 20; ++k) {
    std::vector<VerifiedCandidate> more(1);
    more.front().candidate.T_map_base = Pose2(400, 10 * k, 0);
    found.set.spawn(std::move(more), found.robot.observation(), 1, found.past);
  }
  REQUIRE(found.set.alive().size() == 20);
  found.robot.drive_to(kStart);
  found.set.track(found.robot.observation(), 1, coarse_points(found.robot.sample()), {0.5, 0.3});
  CHECK(distance_m(found.judged_at.at(found.judged_at.size() - 20), kStart) < 0.03);
}

TEST_CASE("where dead reckoning has failed, the fifteen best hypotheses are searched, and no others") {
  constexpr int kRooms = 18, kSearched = 15;
  const auto in_room = [](int k) { return Pose2(40.0 * k, 0, 0); };
  Features rooms;
  for (int k = 0; k < kRooms; ++k)
    for (const Feature& feature : moved(in_room(k), room())) rooms.push_back(feature);
  const Pose2 off(0.6, 0, 0.2);
  Found found(off, view_of(rooms));
  for (int k = 1; k < kRooms; ++k) {
    std::vector<VerifiedCandidate> more(1);
    more.front().candidate.T_map_base = in_room(k) * kStart * off;
    found.set.spawn(std::move(more), found.robot.observation(), 1, found.past);
  }
  REQUIRE(found.set.alive().size() == kRooms);
  found.judged_at.clear();
  found.robot.drive_to(kStart);
  found.set.track(found.robot.observation(), 1, coarse_points(found.robot.sample()), {0.7, 0.3});
  int right = 0;
  for (int k = 0; k < kRooms; ++k)
    right += std::ranges::any_of(found.judged_at, [&](const Pose2& pose) {
      return distance_m(pose, in_room(k) * kStart) < 0.05 && angle_between_rad(pose, kStart) < 0.02;
    });
  CHECK(right == kSearched);
}

TEST_CASE("of a hypothesis that a better aligned candidate moves, the pose is known as well as one just found") {
  Found found;
  const auto trace = [&] { return found.set.alive().at(0).pose.covariance().trace(); };
  const double just_found = trace();
  for (int k = 1; k <= 4; ++k) {
    found.robot.drive_to(kStart * Pose2(0.3 * k, 0, 0));
    found.set.track(found.robot.observation(), 1, {}, {0, 0});
  }
  REQUIRE(trace() < 0.8 * just_found);
  const Pose2 there = found.T_map_base() * Pose2(0.25, 0, 0);
  found.nat_at = [&](const Pose2& pose) { return distance_m(pose, there) < 0.1 ? 3 : 1; };
  std::vector<VerifiedCandidate> better(1);
  better.front().candidate.T_map_base = there;
  found.set.spawn(std::move(better), found.robot.observation(), 1, found.past);
  REQUIRE(found.set.alive().size() == 1);
  CHECK(distance_m(found.T_map_base(), there) < 1e-9);
  CHECK(trace() == Approx(just_found));
}
