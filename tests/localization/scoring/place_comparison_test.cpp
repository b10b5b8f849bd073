#include "localization/scoring/place_comparison.hpp"
#include "localization/tree/hypothesis_set.hpp"
#include "tests/localization/synthetic_scene.hpp"
#include "tests/localization/tree/deaf_listener.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;
using namespace opal::synthetic;

namespace {

constexpr HypothesisId kHere{0}, kThere{1};
constexpr double kMemory = 0.99;
const Pose2 kTo_there(100, 0, 0);

/// Two rooms alike, 100 m apart; what the robot sees is the first one.
struct TwoRooms {
  explicit TwoRooms(const Features& only_here = {}, const Features& only_there = {}) : robot(here(only_here), {}) {
    Features all = moved(kTo_there, room());
    const Features first = room(), elsewhere = moved(kTo_there, only_there);
    for (const Features* some : {&first, &only_here, &elsewhere}) all.insert(all.end(), some->begin(), some->end());
    map = view_of(all);
  }
  static std::shared_ptr<const MapView> here(const Features& only_here) {
    Features all = room();
    all.insert(all.end(), only_here.begin(), only_here.end());
    return view_of(all);
  }
  static Pose2 way(int k) { return {2 + 0.3 * (k % 10), 2.2, 0.4 * k}; }
  /// Both places; the robot is at the first one.
  std::vector<PlaceComparison::Place> places() const {
    return {{kHere, robot.T_map_base()}, {kThere, kTo_there * robot.T_map_base()}};
  }
  /// Drives through the room, and looks at it from ten places.
  PlaceComparison driven(int times = 1, int most_places = 4, bool reversed = false) {
    PlaceComparison comparison(map, most_places, kMemory);
    for (int k = 0; k < 10 * times; ++k) {
      robot.drive_to(way(k));
      std::vector<PlaceComparison::Place> all = places();
      if (reversed) std::reverse(all.begin(), all.end());
      comparison.add({robot.observation().scans, 0.5, all});
    }
    return comparison;
  }
  std::shared_ptr<const MapView> map;
  Robot robot;
};

Feature column() { return {"opal:Column", Circle{{4, 5.2}, 0.25}}; }

/// Hypotheses at both places, which the scorer cannot tell apart. The robot is at the first one.
struct Undecided {
  explicit Undecided(int compared_places) : options(comparing(compared_places)) {
    rooms.robot.drive_to({2, 2.2, 0});
    std::vector<VerifiedCandidate> both(2);
    both[0].candidate.T_map_base = rooms.robot.T_map_base();
    both[1].candidate.T_map_base = kTo_there * rooms.robot.T_map_base();
    for (VerifiedCandidate& one : both) one.verdict = judges.ensemble.judge({}, rooms.robot.observation());
    set.spawn(std::move(both), rooms.robot.observation(), 1, past);
  }
  static LocalizerOptions comparing(int places) {
    LocalizerOptions options;
    options.hypotheses.compared_places = places;
    return options;
  }
  void drive(int from = 1) {
    for (int k = from; k < from + 9; ++k) {
      rooms.robot.drive_to({2 + 0.3 * (k % 10), 2.2, 0.4 * k});
      set.track(rooms.robot.observation(), 0.5, {}, {0, 0});
    }
    REQUIRE(set.alive().size() == 2);
  }
  /// By how much the hypothesis at the first place leads.
  double lead_nat() const {
    const Live &best = set.alive()[0], &other = set.alive()[1];
    const double lead = best.hypothesis.log_likelihood - other.hypothesis.log_likelihood;
    return best.hypothesis.T_map_local.x() < other.hypothesis.T_map_local.x() ? lead : -lead;
  }

  TwoRooms rooms{{column()}};
  Judges judges{rooms.map, {{"constant", constant_scorer(1), ScorerRole::decides, 1}}};
  RetrospectiveVerification past{rooms.map, judges.ensemble, no_earlier_scans(), 1};
  DeafListener nobody;
  LocalizerOptions options;
  HypothesisSet set{rooms.map, judges.ensemble, options, nobody};
};

}  // namespace

TEST_CASE("a column that only one of two equal rooms has tells them apart") {
  const PlaceComparison seen = TwoRooms({column()}).driven();
  CHECK(seen.against_nat(kThere) > 0.5);
  CHECK(seen.against_nat(kHere) == 0);
}

TEST_CASE("so does a column that should be seen and is not") {
  const PlaceComparison seen = TwoRooms({}, {column()}).driven();
  CHECK(seen.against_nat(kThere) > 0.5);
  CHECK(seen.against_nat(kHere) == 0);
}

TEST_CASE("what two places have in common says nothing, however long it is seen") {
  const PlaceComparison seen = TwoRooms().driven(20);
  CHECK(seen.against_nat(kHere) == 0);
  CHECK(seen.against_nat(kThere) == 0);
}

TEST_CASE("what is seen again and again says ever less") {
  TwoRooms rooms({column()});
  const double once = rooms.driven(1).against_nat(kThere), often = rooms.driven(10).against_nat(kThere),
               more_often = rooms.driven(20).against_nat(kThere);
  CHECK(often < 3 * once);
  CHECK(more_often - often < often - once);
}

TEST_CASE("which of two places leads does not matter to their comparison") {
  TwoRooms rooms({column()});
  CHECK(rooms.driven(1, 4, true).against_nat(kThere) == rooms.driven().against_nat(kThere));
}

TEST_CASE("places that have little in common are not compared") {
  Features walls;
  for (double x : {1.0, 3.0, 5.0, 7.0}) walls.push_back({"opal:Line", Segment{{x + 0.5, 3.2}, {x - 0.5, 3.2}}});
  CHECK(TwoRooms({}, walls).driven().against_nat(kThere) == 0);
}

TEST_CASE("a deployment can do without comparisons") {
  CHECK(TwoRooms({column()}).driven(1, 0).against_nat(kThere) == 0);
  CHECK(TwoRooms({column()}).driven(1, 1).against_nat(kThere) == 0);
}

TEST_CASE("a hypothesis that ends takes its comparisons along") {
  TwoRooms rooms({column()});
  PlaceComparison seen = rooms.driven();
  const std::vector<PlaceComparison::Place> left{rooms.places()[1]};
  seen.add({{}, 0.5, left});
  CHECK(seen.against_nat(kThere) == 0);
}

TEST_CASE("a place that comes late has to explain what was seen before, as if it had been there all along") {
  TwoRooms rooms({column()});
  const double all_along_nat = rooms.driven().against_nat(kThere);
  std::vector<Observation> observations;
  std::vector<std::vector<PlaceComparison::Place>> places;
  for (int k = 0; k < 10; ++k) {
    rooms.robot.drive_to(TwoRooms::way(k));
    observations.push_back(rooms.robot.observation());
    places.push_back(rooms.places());
  }
  std::vector<PlaceComparison::Sight> before;
  for (std::size_t k = 0; k < places.size(); ++k) before.push_back({observations[k].scans, 0.5, places[k]});
  PlaceComparison late(rooms.map, 4, kMemory);

  SECTION("once only") {
    for (int times = 0; times < 2; ++times) late.look_back(before, rooms.places());
    CHECK(late.against_nat(kThere) == Approx(all_along_nat).epsilon(0.1));
    CHECK(late.against_nat(kHere) == 0);
  }
  SECTION("but not where it was not there") {
    for (std::vector<PlaceComparison::Place>& then : places) then.pop_back();
    for (std::size_t k = 0; k < places.size(); ++k) before[k].places = places[k];
    late.look_back(before, rooms.places());
    CHECK(late.against_nat(kThere) == 0);
  }
}

TEST_CASE("of two hypotheses that a scorer cannot tell apart, the one that explains what differs leads") {
  for (const int places : {4, 0}) {
    Undecided robot(places);
    robot.drive();
    CAPTURE(places);
    if (places > 0)
      CHECK(robot.lead_nat() > 0.5);
    else
      CHECK(robot.lead_nat() == Approx(0).margin(1e-9));
  }
}

TEST_CASE("a hypothesis that is found late starts behind the one that explains better what was seen before") {
  Undecided robot(4);
  RetrospectiveVerification past(robot.rooms.map, robot.judges.ensemble, {}, kMemory);
  for (int k = 1; k < 10; ++k) {
    robot.rooms.robot.drive_to(TwoRooms::way(k));
    past.remember(robot.rooms.robot.observation(), KeyframeId(k), 1, 1);
  }
  robot.set.clear();
  for (const Pose2& from_here : {Pose2(), kTo_there}) {
    std::vector<VerifiedCandidate> found(1);
    found[0].candidate.T_map_base = from_here * robot.rooms.robot.T_map_base();
    found[0].verdict = robot.judges.ensemble.judge({}, robot.rooms.robot.observation());
    robot.set.spawn(std::move(found), robot.rooms.robot.observation(), 1, past);
  }
  REQUIRE(robot.set.alive().size() == 2);
  CHECK(robot.lead_nat() > 0.5);
}

TEST_CASE("a ride gives back nothing of what a place in no lift had lost") {
  Undecided robot(4);
  robot.drive();
  const double before_nat = robot.lead_nat();
  const auto lift = [](const Pose2& at) { return std::vector<Pose2>(at.x() < 50, Pose2(at.x() + 1000, at.y(), 0)); };
  robot.set.carry(lift, robot.rooms.robot.observation().local_map.T_local_base());
  robot.set.track(robot.rooms.robot.observation(), 0.5, {}, {0, 0});
  REQUIRE(robot.set.alive().size() == 3);
  const auto nat_near = [&](double x_m) {
    for (const Live& live : robot.set.alive())
      if (std::abs(live.hypothesis.T_map_local.x() - x_m) < 50) return live.hypothesis.log_likelihood;
    return 0.0;
  };
  const double kept = kept_share(0.5, TrackingOptions{}.evidence_memory);
  CHECK(nat_near(0) - nat_near(100) >= kept * (before_nat - std::log(2)) - 1e-9);
}
