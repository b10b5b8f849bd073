#include "sensor_health/range_habits.hpp"
#include "sensor_health/sensor_judgement.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

/// A hundred beams. @param farthest  so many of them have the farthest range. @param hits  that hit anything at all.
Scan beams(int farthest, double farthest_m, int hits = 100) {
  Scan scan;
  for (int beam = 0; beam < hits; ++beam)
    scan.points.push_back({Point::Zero(), beam < farthest ? farthest_m : 1 + 0.001 * beam, 0, beam});
  scan.free_bearings_rad.resize(static_cast<std::size_t>(100 - hits) / 2);
  scan.invalid = 100 - hits - static_cast<int>(scan.free_bearings_rad.size());
  return scan;
}

/// @param odd  scans in which the range is another, shorter one each time.
RangeHabits habits_of(int scans, int odd, int farthest = 10, int hits = 100) {
  RangeHabits habits;
  for (int k = 0; k < scans; ++k) habits.add(beams(farthest, k < odd ? 8 - 0.1 * k : 8.5, hits));
  return habits;
}

}  // namespace

TEST_CASE("the share of usable beams counts what hit, and all that was sent") {
  RangeHabits habits;
  CHECK(habits.usable_share() == 1);
  habits.add(beams(0, 0, 20));
  habits.add(beams(0, 0, 60));
  CHECK(habits.usable_share() == Approx(0.4));
  habits.add(Scan());  // no beam at all
  CHECK(habits.scans() == 2);
  habits.add(beams(0, 0, 0));
  CHECK(habits.scans() == 3);
  CHECK(habits.usable_share() == Approx(80. / 300));
  habits.clear();
  CHECK(habits.scans() == 0);
  CHECK(habits.usable_share() == 1);
}

TEST_CASE("a farthest range that returns in five scans is repeated") {
  CHECK_FALSE(habits_of(4, 0).repeated_farthest());
  CHECK_FALSE(habits_of(10, 6).repeated_farthest());
  const auto repeated = habits_of(12, 6).repeated_farthest();
  REQUIRE(repeated);
  CHECK(repeated->range_m == 8.5);
  CHECK(repeated->scan_share == Approx(0.5));
  CHECK(repeated->beam_share == Approx(0.1));
}

TEST_CASE("a farthest range that one beam has is a hit") {
  CHECK_FALSE(habits_of(10, 0, 1).repeated_farthest());
  CHECK(habits_of(10, 0, 2).repeated_farthest());
  CHECK_FALSE(habits_of(10, 0, 0, 0).repeated_farthest());
}

TEST_CASE("what repeats while other scans see farther is a wall, and contradicts nothing") {
  RangeHabits habits = habits_of(20, 5);
  CHECK(judge_ranges(habits, LaserModel()).size() == 1);
  habits.add(beams(1, 8.55));  // no more than one per cent
  CHECK(habits.repeated_farthest()->farther_share == 0);
  for (int k = 0; k < 2; ++k) habits.add(beams(1, 9 + k));
  CHECK(habits.repeated_farthest()->farther_share == Approx(2. / 23));
  CHECK(judge_ranges(habits, LaserModel()).empty());
}

TEST_CASE("of several repeated ranges the one of most scans counts") {
  RangeHabits habits = habits_of(8, 0);
  for (int k = 0; k < 6; ++k) habits.add(beams(10, 9));
  CHECK(habits.repeated_farthest()->range_m == 8.5);
  for (int k = 0; k < 6; ++k) habits.add(beams(10, 9));
  CHECK(habits.repeated_farthest()->range_m == 9);
}

TEST_CASE("ranges are judged from the tenth scan on, and contradict only if they recur in one of ten") {
  CHECK(judge_ranges(habits_of(9, 0), LaserModel()).empty());
  CHECK(judge_ranges(habits_of(60, 54), LaserModel()).empty());
  const auto found = judge_ranges(habits_of(20, 12), LaserModel());
  REQUIRE(found.size() == 1);
  CHECK(found[0].subject == SensorFinding::Subject::no_return);
  CHECK(found[0].verdict == SensorFinding::Verdict::contradicted);
  CHECK(found[0].found == 8.5);
  CHECK(found[0].described == 80);
  CHECK_THAT(found[0].words, Catch::Contains("10.0 of 100 beams have exactly the range 8.5 m, in 40 of 100 scans"));
}

TEST_CASE("a laser of which two beams in a hundred hit something is described wrongly, and its limits are told") {
  LaserModel laser;
  laser.range_max_m = 30;
  laser.no_return_m = 20;
  CHECK(judge_ranges(habits_of(10, 0, 0, 3), laser).empty());
  const auto found = judge_ranges(habits_of(10, 0, 0, 1), laser);
  REQUIRE(found.size() == 1);
  CHECK(found[0].subject == SensorFinding::Subject::usable_beams);
  CHECK(found[0].found == Approx(0.01));
  CHECK_THAT(found[0].words, Catch::Contains("1.0 of 100 beams hit something between 0.05 and 20.00 m"));
}

TEST_CASE("a laser that goes blind after a long drive is noticed as soon as one that always was") {
  RangeHabits habits = habits_of(20000, 0, 1);
  REQUIRE(habits.scans() == RangeHabits::kScans);
  for (int k = 0; k < RangeHabits::kScans; ++k) habits.add(beams(0, 0, 0));
  CHECK(habits.usable_share() == 0);
  CHECK_FALSE(judge_ranges(habits, LaserModel()).empty());
}

TEST_CASE("a range that begins to repeat after a long drive is noticed, and one that has ceased is not") {
  RangeHabits habits = habits_of(20000, 0, 1);
  for (int k = 0; k < 100; ++k) habits.add(beams(10, 8.5));
  REQUIRE(habits.repeated_farthest());
  CHECK(habits.repeated_farthest()->scan_share == Approx(100. / RangeHabits::kScans));
  for (int k = 0; k < RangeHabits::kScans; ++k) habits.add(beams(1, 8.5));
  CHECK_FALSE(habits.repeated_farthest());
}

TEST_CASE("so many of the newest scans are looked at, and no more") {
  RangeHabits habits;
  for (int k = 0; k < RangeHabits::kScans; ++k) habits.add(beams(0, 0, 50));
  CHECK(habits.scans() == RangeHabits::kScans);
  habits.add(beams(0, 0, 100));
  CHECK(habits.scans() == RangeHabits::kScans);
  CHECK(habits.usable_share() == Approx(0.5 + 0.5 / RangeHabits::kScans));
}
