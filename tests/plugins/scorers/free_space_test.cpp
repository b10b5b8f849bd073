// A robot in the middle of an empty round room of 5 m, and maps of what should stand there.
#include "synthetic_map.hpp"

using namespace opal;

namespace {

std::shared_ptr<const HypothesisScorer> free_space_scorer(const nlohmann::json& options = nlohmann::json::object()) {
  return scorer_of("score_free_space", "opal:FreeSpace", options);
}

/// @param from_rad, to_rad  where the laser sees the room's wall.
Observation seen_around(double radius_m = 5, double from_rad = -std::numbers::pi, double to_rad = std::numbers::pi) {
  Observation observation{no_local_map(), {{.range_max_m = 12}}};
  for (double bearing = from_rad; bearing < to_rad; bearing += 0.05)
    observation.scans.front().points.push_back(radius_m * unit_vector(bearing));
  return observation;
}

double overlap_m(const MapView& map, const Observation& observation,
                 const nlohmann::json& options = {{"margin_m", 0.5}, {"unmatched_m", 0}}) {
  return free_space_scorer(options)->score_new(at(Pose2()), observation, map).breakdown.front().value;
}

const Segment kWall{{3, -1}, {3, 1}};

}  // namespace

TEST_CASE("a wall that should stand in free space speaks against a hypothesis, by its length") {
  CHECK(overlap_m(map_of({{"Wall", kWall}}), seen_around()) == Approx(2));
  CHECK(overlap_m(map_of({{"Wall", Segment{{7, -1}, {7, 1}}}}), seen_around()) == 0);
  const Score score =
      free_space_scorer({{"weight_nat_per_m", 3.0}})->score_new(at(Pose2()), seen_around(), map_of({{"Wall", kWall}}));
  CHECK(score.log_likelihood == Approx(-6));
  CHECK(score.veto.empty());
}

TEST_CASE("what stands within the margin of the room's edge is no evidence") {
  const MapView map = map_of({{"Wall", Segment{{4.7, -0.5}, {4.7, 0.5}}}});
  CHECK(overlap_m(map, seen_around(), {{"margin_m", 0.5}, {"unmatched_m", 0}}) == 0);
  CHECK(overlap_m(map, seen_around(), {{"margin_m", 0.1}, {"unmatched_m", 0}}) == Approx(1));
}

TEST_CASE("more overlap than is allowed ends a hypothesis, and says how much it was") {
  const auto strict = free_space_scorer({{"veto_m", 1.0}});
  CHECK(strict->score_new(at(Pose2()), seen_around(), map_of({{"Wall", kWall}})).veto ==
        "2.00 m of mapped geometry stand in free space, more than 1.00 m");
  CHECK(strict->score_new(at(Pose2(-3, 0, 0)), seen_around(), map_of({{"Wall", kWall}}))
            .veto.empty());  // 6 m before the robot
}

TEST_CASE("a laser that sees half of the room knows nothing of the other half") {
  const Observation half = seen_around(5, -0.5 * std::numbers::pi, 0.5 * std::numbers::pi);
  CHECK(overlap_m(map_of({{"Wall", kWall}}), half) == Approx(2));
  CHECK(overlap_m(map_of({{"Wall", Segment{{-3, -1}, {-3, 1}}}}), half) == 0);
}

TEST_CASE("a wall behind something that the beams end at is no evidence") {
  CHECK(overlap_m(map_of({{"Wall", kWall}}), seen_around(2)) == 0);
}

TEST_CASE("doors and windows are no evidence, columns are by their width") {
  CHECK(overlap_m(map_of({{"Door", kWall}, {"Window", kWall}}), seen_around()) == 0);
  CHECK(overlap_m(map_of({{"Column", Circle{{2, 0}, 0.3}}}), seen_around()) == Approx(0.6));
  CHECK(overlap_m(map_of({{"Corner", OrientedPoint{{2, 0}, 0, 1}}}), seen_around()) == 0);
}

TEST_CASE("doubt in the map is doubt in the evidence") {
  CHECK(overlap_m(map_of({{"Wall", kWall, 0, 0.25}}), seen_around()) == Approx(0.5));
  CHECK(overlap_m(map_of({{"Wall", kWall, 0.5, 1}}), seen_around()) == Approx(2));  // 1.5 m inside, 2 sigma are 1 m
  CHECK(overlap_m(map_of({{"Wall", kWall, 0.9, 1}}), seen_around()) == 0);
}

TEST_CASE("an explanation names the object and where it stands, in the map") {
  const auto findings =
      free_space_scorer()->explain(at(Pose2(10, 0, 0)), seen_around(), map_of({{"Wall", Segment{{13, -1}, {13, 1}}}}));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].words == "2.00 m of Wall thing-0 stand where the scan shows free space");
  CHECK(findings[0].map_feature == MapFeatureNumber(0));
  REQUIRE(findings[0].line.size() == 2);
  CHECK(findings[0].line[0].x() == Approx(13));
}

TEST_CASE("a scan with hardly a beam is no evidence") {
  Observation one = seen_around();
  one.scans.front().points.resize(1);
  CHECK(overlap_m(map_of({{"Wall", kWall}}), one) == 0);
}

TEST_CASE("a free_space_scorer that is asked about two scans in turn answers for each") {
  const MapView map = map_of({{"Wall", kWall}});
  const auto one = free_space_scorer({{"margin_m", 0.5}, {"unmatched_m", 0.0}});
  for (int k = 0; k < 2; ++k) {
    CHECK(one->score_new(at(Pose2()), seen_around(5), map).breakdown.front().value == Approx(2));
    CHECK(one->score_new(at(Pose2()), seen_around(2), map).breakdown.front().value == 0);
  }
}
