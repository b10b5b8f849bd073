#include "localization/search/candidate_generation.hpp"

#include "common/random.hpp"
#include "tests/localization/synthetic_scene.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// So many corners in a row, the first one the nearest.
std::vector<SearchFeature> corners_in_a_row(int count) {
  std::vector<SearchFeature> features;
  for (int k = 0; k < count; ++k)
    features.push_back({{"opal:Corner", OrientedPoint{{1. + k, 0}, 0, 0.5 * std::numbers::pi}}, LocalFeatureId(k)});
  return features;
}

std::vector<Point> coarse_points() {
  std::vector<Point> points;
  for (int k = 0; k < 30; ++k) points.emplace_back(0.2 * k, 3);
  return points;
}

/// What is looked up in the room, which has four corners, each as good as another.
std::vector<CandidateGenerator::LookedUp> looked_up(int corners, int places) {
  SearchOptions options;
  options.places = places;
  const CandidateGenerator generator(view_of(room()), {{"corner", std::make_shared<CornerTemplate>()}}, options);
  CandidateGenerator::Inquiry inquiry =
      generator.ask(corners_in_a_row(corners), coarse_points(), PatternKind::constrained);
  generator.look_up(inquiry, 1000000);
  return generator.propose(std::move(inquiry)).looked_up;
}

}  // namespace

TEST_CASE("of features of one shape the eight best are looked up, the nearest ones of corners") {
  const auto all = looked_up(9, 0);
  CHECK(all.size() == 8);
  for (const auto& each : all) {
    CHECK(each.expected == 4);
    REQUIRE(each.local_features.size() == 1);
    CHECK(each.local_features[0] != LocalFeatureId(8));
  }
  CHECK(looked_up(3, 0).size() == 3);
}

TEST_CASE("patterns are looked up as long as they promise no more places than are wanted, but for three") {
  CHECK(looked_up(8, 17).size() == 4);
  CHECK(looked_up(8, 16).size() == 4);
  CHECK(looked_up(8, 15).size() == 3);
  CHECK(looked_up(8, 3).size() == 3);  // a few times as many are no harm
  CHECK(looked_up(2, 3).size() == 2);
  CHECK(looked_up(8, 1).size() == 1);
  CHECK(looked_up(8, 2000).size() == 8);
}

TEST_CASE("places are kept as by a comparison of each with all that are kept, the first ones first") {
  Random random(7);
  std::vector<Pose2> poses;
  for (int k = 0; k < 400; ++k)
    poses.emplace_back(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-0.5, 0.5));
  const PoseTolerance apart{0.5, 0.3};
  std::vector<std::size_t> expected;
  for (std::size_t k = 0; k < poses.size(); ++k)
    if (std::ranges::none_of(expected, [&](std::size_t kept) { return apart.holds(poses[kept], poses[k]); }))
      expected.push_back(k);
  REQUIRE(expected.size() > 50);
  CHECK(distinct_places(poses, apart, 1000) == expected);
  CHECK(distinct_places(poses, apart, expected.size()) == expected);
  expected.resize(10);
  CHECK(distinct_places(poses, apart, 10) == expected);
  CHECK(distinct_places(poses, apart, 0).empty());
}
