// Laws of the shipped templates: what a pattern says of itself does not depend on where it is, in which order its
// features come, or on noise within the tolerance.
#include "columns.hpp"

#include "patterns/pattern_index.hpp"

#include <algorithm>
#include <numeric>
#include <random>

using namespace opal;

namespace {

const double kPi = std::numbers::pi;

struct Example {
  std::string name;
  std::vector<Feature> features;  // that form one pattern
};

std::vector<Example> examples() {
  return {{"opal:ColumnPair", {column(0, 0), column(7.4, 0)}},
          {"opal:ColumnPair", {column(0, 0, 0.2), column(3, 4, 0.5)}},
          {"opal:CornerPair", {corner(0, 0, kPi / 4), corner(5, 0, 3 * kPi / 4)}},
          {"opal:CornerPair", {corner(0, 0, kPi / 4), corner(5, 3, -3 * kPi / 4)}},
          {"opal:CornerPair", {corner(0, 0, kPi / 4), corner(4, 3, kPi / 4, 1.5 * kPi)}},
          {"opal:ColumnCornerPair", {corner(0, 0, 1), column(4, 3)}},
          {"opal:ColumnWallPair", {wall(-2, 0, 3, 0), column(1, 2)}},
          {"opal:CornerWallPair", {wall(-2, 0, 3, 0), corner(1, 2, -1)}},
          {"opal:Collinear", {column(0, 0), column(7.4, 0.1), column(14.8, 0)}},
          {"opal:Collinear", {column(0, 0), column(3, 0), column(9, 0)}},
          {"opal:CollinearCorners", {corner(0, 0, 1), corner(4, 0, 2, 1.5 * kPi), corner(6, 0, -1)}},
          {"opal:CollinearMixed", {corner(0, 0, 1), column(4, 0), corner(6, 0, -1)}},
          {"opal:LShape", {column(7.4, 0), column(0, 0), column(0, 6.2)}},
          {"opal:LShape", {column(6.2, 0), column(0, 0), column(0, 7.4)}},
          {"opal:LShapeCorners", {corner(4, 0, 2), corner(0, 0, 1), corner(0, 3, -1)}},
          {"opal:LShapeMixed", {corner(4, 0, 2), column(0, 0), corner(0, 3, -1)}}};
}

std::vector<PatternInstance> found(const std::string& name, std::vector<Feature> features) {
  return find_patterns(*shipped(name), features);
}

PatternInstance only(const std::string& name, const std::vector<Feature>& features) {
  auto instances = found(name, features);
  REQUIRE(instances.size() == 1);
  return instances.front();
}

std::vector<Feature> moved(const Pose2& motion, const std::vector<Feature>& features) {
  std::vector<Feature> result;
  for (const Feature& feature : features) result.push_back(transformed(motion, feature));
  return result;
}

/// The poses at which the observed pattern would be the mapped one.
std::vector<Pose2> registrations(const PatternInstance& mapped, const PatternInstance& observed) {
  std::vector<Pose2> poses{mapped.frame * observed.frame.inverse()};
  if (observed.symmetric) poses.push_back(mapped.frame * Pose2(0, 0, kPi) * observed.frame.inverse());
  return poses;
}

}  // namespace

TEST_CASE("a pattern that was moved is found where it was moved to") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-100, 100), angle(-kPi, kPi);
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    const PatternInstance here = only(example.name, example.features);
    const PatternIndex index(std::vector{here});
    for (int k = 0; k < 20; ++k) {
      const Pose2 motion{place(random), place(random), angle(random)};
      const PatternInstance there = only(example.name, moved(motion, example.features));
      REQUIRE(index.find(there).size() == 1);
      const auto poses = registrations(here, there);
      CHECK(std::any_of(poses.begin(), poses.end(), [&](const Pose2& T) {
        return distance_m(T, motion.inverse()) < 1e-6 && angle_between_rad(T, motion.inverse()) < 1e-9;
      }));
    }
  }
}

TEST_CASE("a pattern is the same in whatever order its features come") {
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    const PatternInstance expected = only(example.name, example.features);
    std::vector<int> order(example.features.size());
    std::iota(order.begin(), order.end(), 0);
    while (std::next_permutation(order.begin(), order.end())) {
      std::vector<Feature> shuffled;
      for (const int k : order) shuffled.push_back(example.features[k]);
      const PatternInstance instance = only(example.name, shuffled);
      for (std::size_t k = 0; k < expected.invariants.size(); ++k)
        CHECK(instance.invariants[k].value == expected.invariants[k].value);
      for (std::size_t slot = 0; slot < order.size(); ++slot)
        CHECK(order[instance.members[slot]] == expected.members[slot]);
    }
  }
}

TEST_CASE("noise within tolerance changes neither whether a pattern is found nor the pose, whoever goes first") {
  std::mt19937 random(6);
  std::normal_distribution<double> noise(0, 0.02);
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    const PatternInstance mapped = only(example.name, example.features);
    const PatternIndex index(std::vector{mapped});
    for (int k = 0; k < 200; ++k) {
      std::vector<Feature> seen = example.features;
      for (Feature& feature : seen) {
        feature = transformed(Pose2{noise(random), noise(random), 0}, feature);
        if (auto* circle = std::get_if<Circle>(&feature.geometry)) circle->radius_m += noise(random);
        if (auto* oriented = std::get_if<OrientedPoint>(&feature.geometry)) {
          oriented->heading_rad += noise(random);
          oriented->opening_rad += noise(random);
        }
      }
      const PatternInstance observed = only(example.name, seen);
      REQUIRE(index.find(observed).size() == 1);
      const auto poses = registrations(mapped, observed);
      CHECK(std::any_of(poses.begin(), poses.end(),
                        [](const Pose2& T) { return T.position().norm() < 0.3 && std::abs(T.heading_rad()) < 0.1; }));
    }
  }
}

TEST_CASE("two equal columns are a symmetric pattern, two different ones are not") {
  CHECK(only("opal:ColumnPair", {column(0, 0), column(5, 0)}).symmetric);
  CHECK_FALSE(only("opal:ColumnPair", {column(0, 0, 0.2), column(5, 0, 0.5)}).symmetric);
}

TEST_CASE("corners that face each other along a wall are told apart, corners of one room's diagonal are not") {
  CHECK_FALSE(only("opal:CornerPair", {corner(0, 0, kPi / 4), corner(5, 0, 3 * kPi / 4)}).symmetric);
  CHECK(only("opal:CornerPair", {corner(0, 0, kPi / 4), corner(5, 5, -3 * kPi / 4)}).symmetric);
}

TEST_CASE("evenly spaced columns in a line may be paired both ways, unevenly spaced ones may not") {
  CHECK(only("opal:Collinear", {column(0, 0), column(7.4, 0), column(14.8, 0)}).symmetric);
  const PatternInstance uneven = only("opal:Collinear", {column(0, 0), column(7.4, 0), column(10.4, 0)});
  CHECK_FALSE(uneven.symmetric);
  CHECK(uneven.members == std::vector<int>{2, 1, 0});  // the shorter leg first
  CHECK(uneven.invariants[0].value == Approx(3));
}

TEST_CASE("an L has its lower right end first, and its mirror image is another pattern") {
  const PatternInstance l = only("opal:LShape", {column(0, 0), column(0, 6.2), column(7.4, 0)});
  CHECK(l.members == std::vector<int>{2, 0, 1});
  CHECK(l.invariants[0].value == Approx(7.4));
  CHECK(l.invariants[1].value == Approx(6.2));
  CHECK_FALSE(l.symmetric);
  const PatternInstance mirrored = only("opal:LShape", {column(0, 0), column(0, 6.2), column(-7.4, 0)});
  CHECK(mirrored.invariants[0].value == Approx(6.2));
  CHECK(PatternIndex(std::vector{l}).find(mirrored).empty());
}

TEST_CASE("three columns that are neither straight nor at a right angle are no pattern") {
  const std::vector<Feature> bent{column(0, 0), column(5, 0), column(9, 2.5)};
  CHECK(found("opal:Collinear", bent).empty());
  CHECK(found("opal:LShape", bent).empty());
}

TEST_CASE("an L with one very short leg is none: nobody could tell its corner") {
  CHECK(found("opal:LShape", {column(0, 0), column(10, 0), column(0, 0.8)}).empty());
}

TEST_CASE("a column behind a face is no pattern with it") {
  CHECK(found("opal:ColumnWallPair", {wall(3, 0, -2, 0), column(1, 2)}).empty());
}

TEST_CASE("the thesis' grid of eight columns has twelve L in two sets, and its binary patterns repeat") {
  const auto grid = column_grid(4, 2);
  const auto neighbours = nlohmann::json{{"reach_m", 7.5}};
  const auto all = find_patterns(*shipped("opal:LShape", neighbours), grid);
  CHECK(all.size() == 12);
  const PatternIndex index(all);
  for (const PatternInstance& l : all) CHECK(index.count(l, 100) == 6);
  CHECK(find_patterns(*shipped("opal:ColumnPair", neighbours), grid).size() == 10);
  CHECK(find_patterns(*shipped("opal:Collinear", neighbours), grid).size() == 4);
}
