// A robot in a room of 8 x 6 m, and maps that draw this room in different ways.
#include "made_up_map.hpp"

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

/// @param from_rad, to_rad  where the laser sees the room's walls.
Observation seen(double from_rad = -std::numbers::pi, double to_rad = std::numbers::pi) {
  Observation observation{no_local_map(), {}, {}, 30, Point::Zero(), {}};
  for (double bearing = from_rad + 0.0123; bearing < to_rad; bearing += 0.0628) {
    const Point direction = unit_vector(bearing);
    const double to_x = (direction.x() > 0 ? kHigh.x() : kLow.x()) / direction.x();
    const double to_y = (direction.y() > 0 ? kHigh.y() : kLow.y()) / direction.y();
    observation.points.push_back(std::min(to_x, to_y) * direction);
  }
  return observation;
}

double nat(const std::vector<Thing>& things, const Hypothesis& hypothesis = at(Pose2()), const Observation& observation = seen()) {
  return scorer()->score(hypothesis, observation, map_of(things)).log_likelihood;
}

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
  Hypothesis hypothesis = at(Pose2());
  const double first = one->score(hypothesis, right, map).log_likelihood;
  hypothesis.encounters.take(one->score(hypothesis, right, map).encounters, 1, 1);
  CHECK(one->score(hypothesis, right, map).log_likelihood < 0.8 * first);
  CHECK(one->score(hypothesis, left, map).log_likelihood == Approx(one->score(at(Pose2()), left, map).log_likelihood));
}

TEST_CASE("who judges a scan of before by its patches of then judges as then") {
  Observation then = seen();
  then.patches = no_local_map().patches(then.points);
  CHECK(nat(room(), at(Pose2()), then) == nat(room()));
  std::fill(then.patches.begin(), then.patches.end(), 7);  // all of it one thing
  CHECK(nat(room(), at(Pose2()), then) < nat(room()) - 1);
}

TEST_CASE("an object that some beams end on and others pass through speaks against a hypothesis more than one that is absent") {
  Observation observation = seen();
  for (Point& point : observation.points) {  // the lower half of a wall at x = 2
    const double bearing_rad = std::atan2(point.y(), point.x());
    if (bearing_rad > -0.6 && bearing_rad < 0) point *= 2 / point.x();
  }
  const Point low(2, -1.4), middle(2, 0), high(2, 1.4);
  std::vector<Thing> one = room(), two = room();
  one.push_back({"Wall", Segment{low, high}});
  for (const Segment& half : {Segment{low, middle}, Segment{middle, high}}) two.push_back({"Wall", half});
  const double torn = nat(one, at(Pose2()), observation), absent = nat(two, at(Pose2()), observation);
  CHECK(torn < absent - 0.1);
  CHECK(absent < nat({two.begin(), two.end() - 1}, at(Pose2()), observation));
}

TEST_CASE("what beams ended on before must not be passed through now") {
  const std::vector<Thing> with_wall = {{"Wall", Segment{{2, -1.4}, {2, 1.4}}}};
  Observation ends = seen(-0.5, 0.5);
  for (Point& point : ends.points) point *= 2 / point.x();
  const auto one = scorer();
  const MapView map = map_of(with_wall);
  Hypothesis hypothesis = at(Pose2());
  const Observation passes = seen(-0.5, 0.5);
  const double before = one->score(hypothesis, passes, map).log_likelihood;
  hypothesis.encounters.take(one->score(hypothesis, ends, map).encounters, 1, 1);
  CHECK(one->score(hypothesis, passes, map).log_likelihood < before - 0.5);
}

TEST_CASE("an empty scan says nothing") {
  Observation empty = seen();
  empty.points.clear();
  CHECK(nat(room(), at(Pose2()), empty) == 0);
}
