#include "searching.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// Rooms in a row that look alike.
Features rooms(int count) {
  Features features;
  for (int k = 0; k < count; ++k)
    for (const Feature& feature : moved(Pose2(15.03 * k, 0, 0), room())) features.push_back(feature);
  return features;
}

SearchOptions so_many_per_scan(int places) {
  SearchOptions options;
  options.places_per_scan = places;
  return options;
}

}  // namespace

TEST_CASE("a search that is spread over scans finds what one finds that looks at all places at once") {
  const int places = GENERATE(2, 3, 7, 20);
  CAPTURE(places);
  const auto spread = Searching(rooms(4), kTruth, so_many_per_scan(places)).find();
  const auto at_once = Searching(rooms(4), kTruth, so_many_per_scan(0)).find();
  REQUIRE(spread.candidates.size() == at_once.candidates.size());
  CHECK(spread.places == at_once.places);
  CHECK(spread.looked_up.size() == at_once.looked_up.size());
  for (std::size_t k = 0; k < spread.candidates.size(); ++k) {
    CAPTURE(k);
    CHECK(is_at(spread.candidates[k], at_once.candidates[k].candidate.T_map_base, 1e-9, 1e-9));
    CHECK(spread.candidates[k].nat == at_once.candidates[k].nat);
  }
}

TEST_CASE("the fewer places a scan looks at, the more scans a search takes") {
  std::size_t before = std::numeric_limits<std::size_t>::max();
  for (const int places : {2, 10, 1000}) {
    const Searching searching(rooms(4), kTruth, so_many_per_scan(places));
    const Observation seen = searching.robot.observation();
    StageTimes times;
    GlobalSearch::Ongoing ongoing =
        searching.search.begin({searching.robot.sample(), seen}, UnderConstrained::never, times);
    std::size_t scans = 1;
    while (!searching.search.go_on(ongoing, {searching.robot.sample(), seen}, times)) ++scans;
    CAPTURE(places, scans);
    CHECK(scans < before);
    before = scans;
  }
  CHECK(before == 1);
}

TEST_CASE("a robot that drives on while a search goes on is found where it is then") {
  Searching searching(rooms(4), kTruth, so_many_per_scan(4));
  StageTimes times;
  GlobalSearch::Ongoing ongoing =
      searching.search.begin({searching.robot.sample(), searching.robot.observation()}, UnderConstrained::never, times);
  std::optional<GlobalSearch::Result> found;
  int scans = 0;
  while (!found) {
    searching.robot.drive_to(searching.robot.T_map_base() * Pose2(0.1, 0, 0.02));
    const Observation seen = searching.robot.observation();
    found = searching.search.go_on(ongoing, {searching.robot.sample(), seen}, times);
    ++scans;
  }
  CHECK(scans > 2);
  REQUIRE_FALSE(found->candidates.empty());
  const auto& all = found->candidates;
  CHECK(std::any_of(all.begin(), all.end(),
                    [&](const VerifiedCandidate& each) { return is_at(each, searching.robot.T_map_base()); }));
}

TEST_CASE("a hint is looked at at once, however much of the map is left") {
  const Searching searching(rooms(4), kTruth, so_many_per_scan(1));
  const Observation seen = searching.robot.observation();
  StageTimes times;
  const Pose2 about = kTruth * Pose2(0.3, -0.2, 0.1);
  const auto found = searching.search.look_near({about, 0.5, 0.2}, {searching.robot.sample(), seen}, times);
  REQUIRE_FALSE(found.candidates.empty());
  CHECK(is_at(found.candidates.front(), kTruth));
  for (const VerifiedCandidate& each : found.candidates) {
    CHECK(each.candidate.origin == Origin::hint);
    CHECK_FALSE(each.candidate.pattern.exists());
  }
}
