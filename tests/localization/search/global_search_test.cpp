#include "searching.hpp"

#include "map_tools/map_stack.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// Whether each of `some` is among `all`.
bool all_among(const std::vector<VerifiedCandidate>& some, const Pose2& motion,
               const std::vector<VerifiedCandidate>& all) {
  return std::ranges::all_of(some, [&](const VerifiedCandidate& each) {
    const Pose2 pose = motion * each.candidate.T_map_base;
    return std::ranges::any_of(all, [&](const VerifiedCandidate& other) { return is_at(other, pose, 0.1, 0.05); });
  });
}

SearchOptions in_region(const Point& center, double radius_m) {
  SearchOptions options;
  options.region = RegionPrior{center, radius_m};
  return options;
}

Features two_rooms(const Pose2& T_map_second) {
  Features features = room();
  for (const Feature& feature : moved(T_map_second, room())) features.push_back(feature);
  return features;
}

/// What the robot sees, and also one wall as a detector has it.
Observation with_wall(const Searching& searching, LocalMap& local_map) {
  const Pose2 T_laser_map = (searching.robot.T_map_base() * T_base_laser).inverse();
  Features features = detected_from(*searching.map, searching.robot.T_map_base());
  features.push_back(transformed(T_laser_map, seen_wall({1, 0}, {9, 0})));
  for (Feature& feature : features) feature = transformed(T_base_laser, feature);
  local_map.add(searching.robot.sample(), features);
  return {local_map, searching.robot.observation().scans, features};
}

}  // namespace

TEST_CASE("the true pose is found first, wherever in the room it is") {
  const Pose2 truth = GENERATE(Pose2(6.5, 4.2, 0.4), Pose2(1, 6, -2), Pose2(9, 1, 3.1), Pose2(5, 3.5, 1.6));
  CAPTURE(truth.x(), truth.y(), truth.heading_rad());
  const auto found = Searching(room(), truth).find().candidates;
  REQUIRE_FALSE(found.empty());
  CHECK(is_at(found.front(), truth));
  CHECK(found.front().nat > 2.5);
}

TEST_CASE("candidates stand in order of what the scan says for them, and their verdicts agree") {
  const auto found = Searching().find().candidates;
  REQUIRE(found.size() > 1);
  for (std::size_t k = 0; k < found.size(); ++k) {
    CHECK(found[k].nat == found[k].verdict.nat);
    if (k > 0) CHECK(found[k - 1].nat >= found[k].nat);
  }
}

TEST_CASE("a candidate says what its pattern is on the map") {
  const Searching searching;
  const auto found = searching.find().candidates;
  REQUIRE_FALSE(found.empty());
  const Candidate& best = found.front().candidate;
  CHECK(best.origin == Origin::pattern);
  CHECK(searching.search.pattern_name(best.pattern) == "corner");
  REQUIRE(best.pairs.size() == 1);
  const auto& local = searching.robot.local_map().features();
  const auto seen =
      std::ranges::find_if(local, [&](const LocalFeature& each) { return each.id == best.pairs[0].local_feature; });
  REQUIRE(seen != local.end());
  const Geometry placed = transformed(searching.robot.truth().T_map_local, seen->feature.geometry);
  CHECK(distance_m(searching.map->feature(best.pairs[0].map_feature).geometry, anchor_of(placed)) < 0.05);
}

TEST_CASE("the order of a map's features does not matter to what is found in it") {
  const unsigned seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  Features shuffled = room();
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(seed));
  const auto found = Searching().find().candidates, again = Searching(shuffled).find().candidates;
  CHECK(found.size() == again.size());
  CHECK(all_among(found, Pose2(), again));
}

TEST_CASE("moving a map moves all that is found in it") {
  const Pose2 motion = GENERATE(Pose2(30, -12, 0), Pose2(-7.3, 4.1, 0.9), Pose2(0.03, 0.04, -2.5));
  CAPTURE(motion.x(), motion.y(), motion.heading_rad());
  const auto found = Searching().find().candidates;
  const auto there = Searching(moved(motion, room()), motion * kTruth).find().candidates;
  REQUIRE_FALSE(there.empty());
  CHECK(is_at(there.front(), motion * kTruth));
  CHECK(there.front().nat == Approx(found.front().nat).margin(0.2));
  CHECK(all_among({found.front()}, motion, there));
}

TEST_CASE("two equal rooms are both found, and as good as each other") {
  const Pose2 T_map_second(20, 0, 0);
  const auto found = Searching(two_rooms(T_map_second)).find().candidates;
  REQUIRE(found.size() >= 2);
  const bool first = is_at(found[0], kTruth) && is_at(found[1], T_map_second * kTruth);
  const bool second = is_at(found[1], kTruth) && is_at(found[0], T_map_second * kTruth);
  CHECK((first || second));
  CHECK(found[0].nat == Approx(found[1].nat).margin(0.2));
}

TEST_CASE("who knows roughly where the robot is finds it there only") {
  const Pose2 T_map_second(20, 0, 0);
  const Pose2 there = T_map_second * kTruth;
  const auto found = Searching(two_rooms(T_map_second), kTruth, in_region(there.position(), 3)).find().candidates;
  REQUIRE_FALSE(found.empty());
  CHECK(is_at(found.front(), there));
  for (const VerifiedCandidate& each : found)
    CHECK((each.candidate.T_map_base.position() - there.position()).norm() <
          3 + 0.4);  // alignment may leave it a little
}

TEST_CASE("filters that pass a few of many places pass the true one") {
  const std::size_t whole = GENERATE(0u, 5u, 8u);  // the only room that has all that is seen
  CAPTURE(whole);
  Features features;
  for (std::size_t k = 0; k < 9; ++k) {
    Features next = moved(Pose2(15.03 * static_cast<double>(k), 0, 0), room());
    if (k != whole) next.erase(next.begin() + (k % 2 ? 1 : 5));  // a wall
    features.insert(features.end(), next.begin(), next.end());
  }
  const Pose2 truth = Pose2(15.03 * static_cast<double>(whole), 0, 0) * kTruth;
  SearchOptions options;
  options.close_looks = 10;
  options.candidates = 1;
  const auto found = Searching(features, truth, options).find().candidates;
  REQUIRE(found.size() == 1);
  CHECK(is_at(found.front(), truth));
}

TEST_CASE("nothing is found in a region without anything") {
  CHECK(Searching(room(), kTruth, in_region({500, 500}, 3)).find().candidates.empty());
}

TEST_CASE("no more candidates are found than asked for, the best ones, and the others are told on request") {
  SearchOptions two, many;
  two.hypotheses = 2;
  many.hypotheses = 50;
  const Searching few(room(), kTruth, two);
  const auto found = few.find(UnderConstrained::nothing_good, true);
  CHECK(found.candidates.size() == 2);
  CHECK(is_at(found.candidates.front(), kTruth));
  CHECK_FALSE(found.rejected.empty());
  CHECK(few.find(UnderConstrained::nothing_good, false).rejected.empty());
  CHECK(Searching(room(), kTruth, many).find().candidates.size() > 2);
}

TEST_CASE("where there are fewer places than may be found, all of them are found") {
  SearchOptions options;
  options.hypotheses = 1000;
  const auto found = Searching(room(), kTruth, options).find(UnderConstrained::never, true);
  CHECK(found.candidates.size() < 1000);
  CHECK(found.rejected.empty());
  CHECK(found.candidates.size() <= found.places);
}

TEST_CASE("no two candidates of one kind of pattern are at one place") {
  const auto found = Searching().find(UnderConstrained::never).candidates;
  for (std::size_t a = 0; a < found.size(); ++a)
    for (std::size_t b = a + 1; b < found.size(); ++b)
      CHECK_FALSE(is_at(found[a], found[b].candidate.T_map_base, 0.2, 0.06));
}

TEST_CASE("where nothing is seen, nothing is found") {
  Searching searching;
  searching.robot.drive_blind_to(kTruth * Pose2(0.5, 0, 0));
  const auto found = searching.find();
  CHECK(found.candidates.empty());
  CHECK(found.looked_up.empty());
  CHECK(found.places == 0);
}

TEST_CASE("where no pattern is seen, nothing is found by it") {
  const Searching searching;
  Observation seen = searching.robot.observation();
  seen.features.clear();
  CHECK(searching.find(seen, UnderConstrained::nothing_good).candidates.empty());
}

TEST_CASE("a pattern that the map does not know is not looked up") {
  Features columns_only{{"opal:Column", Circle{{3, 2.2}, 0.4}}, {"opal:Wall", Segment{{0, 0}, {10, 0}}}};
  const Searching unknown(columns_only);
  const Searching known;
  CHECK(unknown.find(known.robot.observation(), UnderConstrained::nothing_good).looked_up.empty());
}

TEST_CASE("without templates nothing is found") { CHECK(Searching(room(), kTruth, {}, {}).find().candidates.empty()); }

TEST_CASE("only stable features are looked up where that is asked for") {
  SearchOptions options;
  options.from_stable = true;
  Searching searching(room(), kTruth, options);
  CHECK(searching.find().candidates.empty());  // seen from one pose only
  for (int k = 0; k < 3; ++k) searching.robot.drive_to(searching.robot.T_map_base() * Pose2(0.2, 0, 0.1));
  const auto found = searching.find().candidates;
  REQUIRE_FALSE(found.empty());
  CHECK(is_at(found.front(), searching.robot.T_map_base()));
}

TEST_CASE("a wall alone finds the robot along it, but only who asks for patterns with a free parameter") {
  const Searching searching(room(), kTruth, {}, {walls()});
  LocalMap local_map({}, nullptr);
  const Observation seen = with_wall(searching, local_map);
  const auto found = searching.find(seen, UnderConstrained::nothing_good).candidates;
  REQUIRE_FALSE(found.empty());
  CHECK(is_at(found.front(), kTruth));
  CHECK(searching.find(seen, UnderConstrained::never).candidates.empty());
}

TEST_CASE("patterns with a free parameter are not looked up where a pose was found by others") {
  const Searching searching(room(), kTruth, {}, {corners(), walls()});
  LocalMap local_map({}, nullptr);
  const Observation seen = with_wall(searching, local_map);
  const auto looked_up = searching.find(seen, UnderConstrained::nothing_good).looked_up;
  CHECK_FALSE(looked_up.empty());
  for (const auto& pattern : looked_up) CHECK(searching.search.pattern_name(pattern.pattern) == "corner");
}

TEST_CASE(
    "where nothing is seen that fixes the pose, patterns with a free parameter may be looked up, and only there") {
  const Searching searching(room(), kTruth, {}, {corners(), walls()});
  LocalMap local_map({}, nullptr);
  Observation seen = with_wall(searching, local_map);
  for (const auto& pattern : searching.find(seen, UnderConstrained::nothing_else).looked_up)
    CHECK(searching.search.pattern_name(pattern.pattern) == "corner");
  std::erase_if(seen.features, [](const auto& each) { return each.type != "opal:Wall"; });
  CHECK(searching.find(seen, UnderConstrained::never).candidates.empty());
  const auto found = searching.find(seen, UnderConstrained::nothing_else).candidates;
  REQUIRE_FALSE(found.empty());
  CHECK(is_at(found.front(), kTruth));
}

TEST_CASE("no two candidates of different kinds of patterns are at one place") {
  SearchOptions options;
  options.under_constrained_below_nat = 100;  // look both up
  const Searching searching(room(), kTruth, options, {corners(), walls()});
  LocalMap local_map({}, nullptr);
  const auto found = searching.find(with_wall(searching, local_map), UnderConstrained::nothing_good).candidates;
  for (std::size_t a = 0; a < found.size(); ++a)
    for (std::size_t b = a + 1; b < found.size(); ++b)
      CHECK_FALSE(is_at(found[a], found[b].candidate.T_map_base, 0.2, 0.06));
}

TEST_CASE("places outside the region do not crowd out those inside") {
  const Pose2 T_map_second(20, 0, 0);
  Features features = room();  // where the robot seems to be, all as seen
  Features second = moved(T_map_second, room());
  second.erase(second.begin() + 5);  // where it is, and the map lacks a wall
  features.insert(features.end(), second.begin(), second.end());
  SearchOptions options = in_region((T_map_second * kTruth).position(), 3);
  options.close_looks = 1;  // as 200 in a map of many rooms
  const auto found = Searching(features, kTruth, options).find().candidates;
  REQUIRE_FALSE(found.empty());
  CHECK(is_at(found.front(), T_map_second * kTruth));
}

namespace {

/// Two storeys that are alike, side by side.
std::shared_ptr<const MapView> two_storeys() {
  const auto storey = std::make_shared<const SemanticMap>(view_of(room())->map());
  const std::vector<StoreyPart> parts{{"lower", "", {}, storey}, {"upper", "", {}, storey}};
  return std::make_shared<MapView>(stacked_map("house", parts).map, "lidar");
}

}  // namespace

TEST_CASE("a place on another storey is a candidate, unless the region leaves it out") {
  const auto house = two_storeys();
  const Pose2 lower = find_storey(house->map(), "lower")->to_map(kTruth),
              upper = find_storey(house->map(), "upper")->to_map(kTruth);
  const auto is_upper = [&](const VerifiedCandidate& each) { return is_at(each, upper); };
  const auto anywhere = Searching(house, lower, {}).find().candidates;
  CHECK(std::ranges::any_of(anywhere, is_upper));
  const auto found = Searching(house, lower, in_region(lower.position(), 8)).find().candidates;
  REQUIRE_FALSE(found.empty());
  CHECK(is_at(found.front(), lower));
  CHECK(std::ranges::none_of(found, is_upper));
}
