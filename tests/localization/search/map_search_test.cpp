#include "localization/search/map_search.hpp"
#include "searching.hpp"

#include <catch2/catch.hpp>

#include <limits>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// A robot in a room, and its searches from scan to scan.
struct Session {
  explicit Session(const SearchOptions& options = {}) : searching(room(), kTruth, options) {}
  std::size_t look(const MapSearch::Need& need = {}, double driven_m = 0) {
    StageTimes times;
    return search.look({searching.robot.sample(), searching.robot.observation()}, Pose2(driven_m, 0, 0), need, times)
        .size();
  }
  /// @return after how many scans something is found; 0: after none of many.
  int scans_until_found() {
    for (int scans = 1; scans < 200; ++scans)
      if (look() > 0) return scans;
    return 0;
  }
  Searching searching;
  MapSearch search{searching.search, {}};
};

SearchOptions one_place_a_scan() {
  SearchOptions options;
  options.places_per_scan = 1;
  return options;
}

}  // namespace

TEST_CASE("after a restart the next scan is the first one, however little the robot has moved") {
  Session session;
  CHECK(session.look() == 1);
  CHECK(session.look() == 0);
  session.search.restart();
  CHECK(session.look() == 1);
}

TEST_CASE("chances to search that passed before a restart do not count") {
  Session session;
  CHECK(session.look({.every = 2}, 0) == 0);
  session.search.restart();
  CHECK(session.look({.every = 2}, 10) == 0);
  CHECK(session.look({.every = 2}, 20) == 1);
}

TEST_CASE("a hint is looked at once, beside a search of the whole map, and survives a restart") {
  Session session;
  CHECK(session.look() == 1);
  session.search.hint({kTruth, 0.2, 0.1});
  session.search.restart();
  CHECK(session.search.has_hint());
  CHECK(session.look() == 2);
  CHECK_FALSE(session.search.has_hint());
  CHECK(session.look() == 0);
}

TEST_CASE("a hint that is forgotten, or not finite, is not looked at") {
  Session session;
  session.search.hint({kTruth, 0.2, 0.1});
  session.search.forget_hint();
  CHECK_FALSE(session.search.has_hint());
  for (const double odd : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const PoseHint& hint : {PoseHint{Pose2(odd, 0, 0), 1, 1}, PoseHint{Pose2(0, 0, odd), 1, 1},
                                 PoseHint{Pose2(), odd, 1}, PoseHint{Pose2(), 1, odd}}) {
      session.search.hint(hint);
      CHECK_FALSE(session.search.has_hint());
    }
}

TEST_CASE("a hint waits for a scan that sees something") {
  Session session;
  const Pose2 there = session.searching.robot.T_map_base();
  session.search.hint({there, 0.2, 0.1});
  session.searching.robot.drive_blind_to(there);
  CHECK(session.look({.at_once = true}) == 0);
  CHECK(session.search.has_hint());
  session.searching.robot.drive_to(there);
  CHECK(session.look() >= 1);
}

TEST_CASE(
    "a search that takes several scans goes on, begins anew where that is asked for, and ends where it is given up") {
  Session session(one_place_a_scan());
  const int scans = session.scans_until_found();
  REQUIRE(scans > 2);
  session.search.restart();
  for (int k = 1; k < scans; ++k) REQUIRE(session.look() == 0);
  CHECK(session.look({.at_once = true}) == 1);  // it is under way: no new one begins
  session.search.restart();
  for (int k = 1; k < scans; ++k) REQUIRE(session.look() == 0);
  CHECK(session.look({.at_once = true, .anew = true}) == 0);
  CHECK(session.scans_until_found() == scans - 1);
  session.search.restart();
  CHECK(session.look() == 0);
  session.search.abandon();
  CHECK(session.scans_until_found() == 0);
}

TEST_CASE("a search that is under way is over with a restart") {
  Session session(one_place_a_scan());
  const int scans = session.scans_until_found();
  REQUIRE(scans > 2);
  session.search.restart();
  for (int k = 0; k < 2; ++k) REQUIRE(session.look() == 0);
  session.search.restart();
  CHECK(session.scans_until_found() == scans);
}
