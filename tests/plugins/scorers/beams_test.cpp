// A robot in a room of 8 x 6 m, and maps that draw this room in different ways.
#include "synthetic_map.hpp"

using namespace opal;

namespace {

std::shared_ptr<const HypothesisScorer> scorer(const nlohmann::json& options = nlohmann::json::object()) {
  return scorer_of("score_beams", "opal:Beams", options);
}

const Point kLow(-3, -2), kHigh(5, 4);

/// The walls of the room, seen from inside, each in so many pieces, moved rigidly.
std::vector<Thing> room(int pieces = 1, const Pose2& moved = Pose2()) {
  const std::vector<Point> corners{kLow, {kLow.x(), kHigh.y()}, kHigh, {kHigh.x(), kLow.y()}, kLow};
  std::vector<Thing> walls;
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    for (int piece = 0; piece < pieces; ++piece) {
      const auto at = [&](int n) { return moved * Point(corners[k] + (corners[k + 1] - corners[k]) * n / pieces); };
      walls.push_back({"Wall", Segment{at(piece), at(piece + 1)}});
    }
  return walls;
}

/// What the framework does: each return has its evidence cell.
void give_cells(Observation& observation) {
  for (ObservedScan& scan : observation.scans) scan.evidence_cells = observation.local_map.evidence_cells(scan.points);
}

/// @param from_rad, to_rad  where the laser sees the room's walls.
Observation seen(double from_rad = -std::numbers::pi, double to_rad = std::numbers::pi) {
  Observation observation{no_local_map(), {{.range_max_m = 30}}};
  for (double bearing = from_rad + 0.0123; bearing < to_rad; bearing += 0.0628) {
    const Point direction = unit_vector(bearing);
    const double to_x = (direction.x() > 0 ? kHigh.x() : kLow.x()) / direction.x();
    const double to_y = (direction.y() > 0 ? kHigh.y() : kLow.y()) / direction.y();
    observation.scans.front().points.push_back(std::min(to_x, to_y) * direction);
  }
  give_cells(observation);
  return observation;
}

double nat(const std::vector<Thing>& things, const Hypothesis& hypothesis = at(Pose2()),
           const Observation& observation = seen()) {
  return scorer()->score_new(hypothesis, observation, map_of(things)).log_likelihood;
}

/// A hypothesis at the origin, with what the scorer remembers of it.
class Remembering {
 public:
  Remembering(const HypothesisScorer& scorer, const MapView& map)
      : scorer_(scorer), map_(map), memory_(scorer.new_memory(map)) {}

  double nat(const Observation& observation) const { return score(observation).log_likelihood; }
  void remember(const Observation& observation) { scorer_.remember(*memory_, *score(observation).seen, 1); }

 private:
  Score score(const Observation& observation) const {
    return scorer_.score(at(Pose2()), observation, map_, memory_.get());
  }

  const HypothesisScorer& scorer_;
  const MapView& map_;
  std::unique_ptr<ScorerMemory> memory_;
};

}  // namespace

TEST_CASE("a wall that a map draws in pieces tells as much as the same wall of one") {
  const double whole = nat(room());
  CHECK(whole > 3);
  for (const int pieces : {2, 3, 10}) CHECK(nat(room(pieces)) == Approx(whole));
}

TEST_CASE("a map with a piece of wall less explains less, however many pieces the rest is of") {
  for (const int pieces : {3, 10}) {
    std::vector<Thing> without = room(pieces);
    without.erase(without.begin() + pieces / 2);
    CHECK(nat(without) < nat(room()) - 0.05);
  }
}

TEST_CASE("the map and the robot moved together change nothing") {
  for (const Pose2& moved : {Pose2(103, -57, 0.7), Pose2(-9, 4, 3), Pose2(0, 0, -1.6)})
    CHECK(nat(room(3, moved), at(moved)) == Approx(nat(room(3))).epsilon(1e-6));
}

TEST_CASE("what was seen from here before is hardly news, and what is new is") {
  const auto one = scorer();
  const MapView map = map_of(room());
  const Observation right = seen(-1.5, 0), left = seen(1.5, 3);
  Remembering hypothesis(*one, map);
  const double first = hypothesis.nat(right);
  hypothesis.remember(right);
  CHECK(hypothesis.nat(right) < 0.8 * first);
  CHECK(hypothesis.nat(left) == Approx(one->score_new(at(Pose2()), left, map).log_likelihood));
}

TEST_CASE("returns tell less if they are of one evidence cell") {
  Observation one_thing = seen();
  std::vector<EvidenceCell>& cells = one_thing.scans.front().evidence_cells;
  std::fill(cells.begin(), cells.end(), EvidenceCell(7));
  CHECK(nat(room(), at(Pose2()), one_thing) < nat(room()) - 1);
}

TEST_CASE(
    "an object that some beams end on and others pass through speaks against a hypothesis more than one that is "
    "absent") {
  Observation observation = seen();
  for (Point& point : observation.scans.front().points) {  // the lower half of a wall at x = 2
    const double bearing_rad = std::atan2(point.y(), point.x());
    if (bearing_rad > -0.6 && bearing_rad < 0) point *= 2 / point.x();
  }
  give_cells(observation);
  const Point low(2, -1.4), middle(2, 0), high(2, 1.4);
  std::vector<Thing> one = room(), two = room();
  one.push_back({"Wall", Segment{low, high}});
  for (const Segment& half : {Segment{low, middle}, Segment{middle, high}}) two.push_back({"Wall", half});
  const double torn = nat(one, at(Pose2()), observation), absent = nat(two, at(Pose2()), observation);
  CHECK(torn < absent - 0.05);
  const auto dearer = scorer({{"conflict_nat", 2.4}});
  const auto dear = [&](const std::vector<Thing>& things) {
    return dearer->score_new(at(Pose2()), observation, map_of(things)).log_likelihood;
  };
  CHECK(dear(one) < dear(two) - 0.1);
  CHECK(absent < nat({two.begin(), two.end() - 1}, at(Pose2()), observation));
}

TEST_CASE("what beams ended on before must not be passed through now") {
  const std::vector<Thing> with_wall = {{"Wall", Segment{{2, -1.4}, {2, 1.4}}}};
  Observation ends = seen(-0.5, 0.5);
  for (Point& point : ends.scans.front().points) point *= 2 / point.x();
  give_cells(ends);
  const auto one = scorer();
  const MapView map = map_of(with_wall);
  Remembering hypothesis(*one, map);
  const Observation passes = seen(-0.5, 0.5);
  const double before = hypothesis.nat(passes);
  hypothesis.remember(ends);
  CHECK(hypothesis.nat(passes) < before - 0.5);
}

namespace {

/// A scan without returns of which a detector has found this face.
Observation with_face(const Segment& face, std::array<bool, 2> true_end, const Pose2& T_map_base = Pose2()) {
  Observation observation = seen();
  observation.scans.front().points.clear();
  give_cells(observation);
  Feature feature;
  feature.geometry = Segment{T_map_base.inverse() * face.begin, T_map_base.inverse() * face.end};
  feature.true_end = true_end;
  observation.features.push_back(feature);
  observation.feature_scans.push_back(0);
  return observation;
}

const Segment kFace{{4, -1}, {4, 2}};

}  // namespace

TEST_CASE("an end of a wall that is seen where the map has one speaks for a place") {
  const std::vector<Thing> map{{"Wall", kFace}};
  const double both = nat(map, at(Pose2()), with_face(kFace, {true, true}));
  CHECK(both > 0.5);
  const double one = nat(map, at(Pose2()), with_face(kFace, {true, false}));
  CHECK(one > both / 2);  // the second one on a line is less of a surprise
  CHECK(one < both);
  CHECK(nat(map, at(Pose2()), with_face(kFace, {false, false})) == 0);  // occluded there, or at the edge of the view
  for (const Pose2& moved : {Pose2(103, -57, 0.7), Pose2(-9, 4, 3)})
    CHECK(nat({{"Wall", Segment{moved * kFace.begin, moved * kFace.end}}}, at(moved), with_face(kFace, {true, true})) ==
          Approx(both).epsilon(1e-6));
}

TEST_CASE("an end that is seen elsewhere on a wall, or of another wall, is no end of it") {
  const std::vector<Thing> map{{"Wall", kFace}};
  const Point up(0, 1);
  const auto ends_there = [&](const Segment& face) { return nat(map, at(Pose2()), with_face(face, {true, true})); };
  CHECK(ends_there({kFace.begin + 0.6 * up, kFace.end - 0.6 * up}) == 0);
  CHECK(ends_there({kFace.end, kFace.begin}) == 0);                  // its other side
  CHECK(ends_there({kFace.begin, kFace.begin + Point(2, 2)}) == 0);  // turned
  CHECK(ends_there({kFace.begin + 5 * up, kFace.end + 5 * up}) == 0);
}

TEST_CASE("the nearer an end is to the mapped one the more it says, and walls may be off across rather than along") {
  const std::vector<Thing> map{{"Wall", kFace}};
  const auto off = [&](const Point& by) {
    return nat(map, at(Pose2()), with_face({kFace.begin + by, kFace.end + by}, {true, true}));
  };
  CHECK(off({0, 0}) > off({0, 0.1}));
  CHECK(off({0, 0.1}) > off({0, 0.2}));
  CHECK(off({0.25, 0}) > off({0, 0.25}));
}

TEST_CASE("ends on one line are one thing, ends of walls apart are two") {
  const Segment further{{4, 3}, {4, 5}}, aside{{6, 3}, {6, 5}};
  const auto two_ends = [&](const Segment& second) {
    Observation observation = with_face(kFace, {false, true});
    observation.features.push_back(with_face(second, {true, false}).features.front());
    observation.feature_scans.push_back(0);
    return nat({{"Wall", kFace}, {"Wall", second}}, at(Pose2()), observation);
  };
  const double single = nat({{"Wall", kFace}}, at(Pose2()), with_face(kFace, {false, true}));
  CHECK(two_ends(aside) == Approx(2 * single));
  CHECK(two_ends(further) < 1.9 * single);
}

TEST_CASE("an end that was seen before is hardly news") {
  const auto one = scorer();
  const MapView map = map_of({{"Wall", kFace}});
  const Observation observation = with_face(kFace, {true, true});
  Remembering hypothesis(*one, map);
  double last = hypothesis.nat(observation), total = last;
  for (int scan = 0; scan < 20; ++scan) {
    hypothesis.remember(observation);
    const double now = hypothesis.nat(observation);
    CAPTURE(scan);
    CHECK(now < last);
    total += last = now;
  }
  CHECK(last < 0.05);
  CHECK(total < 4);
}

TEST_CASE("another end of a line tells more than the same end once more, in one scan or in two") {
  const auto one = scorer();
  const MapView map = map_of({{"Wall", kFace}});
  const Observation begin = with_face(kFace, {true, false}), end = with_face(kFace, {false, true});
  Remembering hypothesis(*one, map);
  const auto score = [&](const Observation& observation) { return hypothesis.nat(observation); };
  const auto with_begin = [&](Observation observation) {
    observation.features.push_back(begin.features.front());
    observation.feature_scans.push_back(0);
    return observation;
  };
  CHECK(score(with_begin(end)) > score(with_begin(begin)) + 0.1);
  hypothesis.remember(begin);
  CHECK(score(end) > score(begin) + 0.1);
}

TEST_CASE("without evidence of ends no end counts") {
  const auto without = scorer({{"end_nat", 0}});
  const Score score = without->score_new(at(Pose2()), with_face(kFace, {true, true}), map_of({{"Wall", kFace}}));
  CHECK(score.log_likelihood == 0);
}

TEST_CASE("an empty scan says nothing") {
  Observation empty = seen();
  empty.scans.front().points.clear();
  give_cells(empty);
  CHECK(nat(room(), at(Pose2()), empty) == 0);
}
