#include "localization/search/search_schedule.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

SearchScheduleOptions schedule_options() {
  SearchScheduleOptions chosen;
  chosen.every_m = 0.5;
  chosen.every_rad = 1;
  return chosen;
}

/// A robot that drives along x; the schedule's answer after each step.
struct Driving {
  explicit Driving(const SearchScheduleOptions& given = schedule_options()) : schedule(given) {}
  bool step(double by_m, int every = 1, bool at_once = false) {
    at_m += by_m;
    return schedule.time_to_search({at_m, 0, 0}, at_once, every);
  }
  /// In how many of so many steps, each of them a chance, it searched.
  int searches_in(int steps, int every) {
    int searches = 0;
    for (int k = 0; k < steps; ++k) searches += step(0.6, every);
    return searches;
  }
  SearchSchedule schedule;
  double at_m = 0;
};

}  // namespace

TEST_CASE("the first scan is a chance to search, standing still is none") {
  Driving robot;
  CHECK(robot.step(0));
  for (int k = 0; k < 10; ++k) CHECK_FALSE(robot.step(0));
}

TEST_CASE("small steps add up to a chance to search") {
  Driving robot;
  REQUIRE(robot.step(0));
  int searches = 0;
  for (int k = 0; k < 100; ++k) searches += robot.step(0.1);  // 10 m
  CHECK(searches >= 10.0 / (0.5 + 0.1) - 1);
  CHECK(searches <= 10.0 / 0.5);
}

TEST_CASE("turning on the spot brings chances to search, to either side") {
  for (const double side : {1.0, -1.0}) {
    SearchSchedule schedule(schedule_options());
    REQUIRE(schedule.time_to_search(Pose2(), false, 1));
    CHECK_FALSE(schedule.time_to_search(Pose2(0, 0, side * 0.9), false, 1));
    CHECK(schedule.time_to_search(Pose2(0, 0, side * 1.1), false, 1));
    CHECK_FALSE(schedule.time_to_search(Pose2(0, 0, side * 2.0), false, 1));
    CHECK(schedule.time_to_search(Pose2(0, 0, side * 2.2), false, 1));
  }
}

TEST_CASE("so many chances as asked for make one search") {
  Driving robot;
  CHECK(robot.searches_in(60, 1) == 60);
  CHECK(robot.searches_in(60, 2) == 30);
  CHECK(robot.searches_in(60, 6) == 10);
}

TEST_CASE("who asks for a search at once need not move") {
  Driving robot;
  REQUIRE(robot.step(0));
  CHECK(robot.step(0, 1, true));
  CHECK(robot.step(0, 1, true));
  CHECK_FALSE(robot.step(0));
}

TEST_CASE("a search at once counts like any other: the next chance is as far away") {
  Driving robot;
  robot.step(0);
  robot.step(0.4);
  CHECK(robot.step(0, 1, true));
  CHECK_FALSE(robot.step(0.4));
  CHECK(robot.step(0.2));
}

TEST_CASE("a schedule that is reset is a new one") {
  Driving robot;
  robot.step(0);
  robot.step(0.6);
  robot.schedule.reset();
  CHECK(robot.step(0));
  CHECK(robot.step(0.6));
}
