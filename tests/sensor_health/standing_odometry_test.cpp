#include "sensor_health/standing_odometry.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

/// @param changed  so many of the beams hit a metre farther.
Scan seen_at(double stamp_s, int changed = 0, int beams = 40, double by_m = 1) {
  Scan scan;
  scan.stamp_s = stamp_s;
  for (int beam = 0; beam < beams; ++beam)
    scan.points.push_back({Point::Zero(), beam < changed ? 2 + by_m : 2, 0, beam});
  return scan;
}

/// Odometry that stands from before one scan until another.
StandingOdometry stood(const Scan& before, const Scan& now) {
  StandingOdometry odometry;
  odometry.add(before, Pose2());  // where it stands
  odometry.add(before, Pose2());
  odometry.add(now, Pose2());
  return odometry;
}

}  // namespace

TEST_CASE("odometry that stands while more than a third of the beams change has frozen") {
  CHECK(stood(seen_at(10), seen_at(12, 20)).changed_share() == Approx(0.5));
  CHECK(stood(seen_at(10), seen_at(12, 15)).is_frozen());
  CHECK(stood(seen_at(10), seen_at(12, 13)).changed_share() == Approx(0.325));
  CHECK_FALSE(stood(seen_at(10), seen_at(12, 13)).is_frozen());
  CHECK_FALSE(stood(seen_at(10), seen_at(12)).is_frozen());
}

TEST_CASE("a beam has changed if its range did by a decimetre, or if it begins or ends to hit") {
  CHECK(stood(seen_at(10), seen_at(12, 40, 40, 0.08)).changed_share() == 0);
  CHECK(stood(seen_at(10), seen_at(12, 40, 40, -0.12)).changed_share() == 1);
  Scan sparse = seen_at(10), later = seen_at(12);
  const auto is_odd = [](const ScanPoint& point) { return point.beam % 2 == 1; };
  std::erase_if(sparse.points, is_odd);
  CHECK(stood(sparse, later).changed_share() == Approx(19. / 39));
  std::erase_if(later.points, is_odd);
  CHECK(stood(sparse, later).changed_share() == 0);
}

TEST_CASE("a few beams say nothing of odometry") {
  CHECK(stood(seen_at(10, 0, 19), seen_at(12, 19, 19)).changed_share() == 0);
  CHECK(stood(seen_at(10, 0, 20), seen_at(12, 20, 20)).changed_share() == 1);
}

TEST_CASE("beams are looked at a second apart") {
  StandingOdometry odometry;
  for (const double stamp_s : {9.9, 10.0, 10.5, 10.9}) odometry.add(seen_at(stamp_s, stamp_s > 10 ? 20 : 0), Pose2());
  CHECK(odometry.changed_share() == 0);
  odometry.add(seen_at(11.1, 20), Pose2());
  CHECK(odometry.changed_share() == Approx(0.5));
  odometry.add(seen_at(12.2, 20), Pose2());
  CHECK(odometry.changed_share() == 0);
}

TEST_CASE("odometry that moves again is not frozen, however short the way") {
  for (const Pose2& moved : {Pose2(0.006, 0, 0), Pose2(0, 0, 0.006)}) {
    StandingOdometry odometry = stood(seen_at(10), seen_at(12, 20));
    odometry.add(seen_at(12.1, 20), moved);
    CHECK(odometry.changed_share() == 0);
  }
  StandingOdometry odometry = stood(seen_at(10), seen_at(12, 20));
  odometry.add(seen_at(12.1, 20), Pose2(0.004, 0, 0.004));
  CHECK(odometry.is_frozen());
}

TEST_CASE("what was seen before odometry moved is not held against what is seen after") {
  StandingOdometry odometry = stood(seen_at(10), seen_at(12));
  odometry.add(seen_at(12.5, 40), Pose2(1, 0, 0));
  odometry.add(seen_at(14, 40), Pose2(1, 0, 0));
  odometry.add(seen_at(16, 40), Pose2(1, 0, 0));
  CHECK(odometry.changed_share() == 0);
}

TEST_CASE("a clock that jumps back begins a new look, and tells nothing by itself") {
  StandingOdometry odometry = stood(seen_at(10), seen_at(12));
  odometry.add(seen_at(3, 40), Pose2());
  CHECK(odometry.changed_share() == 0);
  odometry.add(seen_at(4.5, 40), Pose2());
  CHECK(odometry.changed_share() == 0);
  odometry.add(seen_at(6, 20), Pose2());
  CHECK(odometry.changed_share() == Approx(0.5));
}
