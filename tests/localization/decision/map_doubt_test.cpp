#include "localization/decision/map_doubt.hpp"
#include "tests/localization/decision/made_status.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

constexpr double kPoor = 0.5, kRight = 0.9, kSilent = 1;  // share of beams that end on the map

void drive(MapDoubt& doubt, int pieces, double agreeing, bool is_localized) {
  for (int k = 0; k < 4 * pieces; ++k) doubt.add(agreeing, 0.25, is_localized);
}

}  // namespace

TEST_CASE("a map is doubted once nothing was localized for long, and beams pass through what it has") {
  MapDoubt doubt(20);
  drive(doubt, 19, kPoor, false);
  CHECK(doubt.words().empty());
  drive(doubt, 2, kPoor, false);
  CHECK_THAT(doubt.words(), Catch::Contains("no place held for 21 pieces") && Catch::Contains("50 % of the beams"));
}

TEST_CASE("a map in which places look alike, or that a robot is localized on, is not doubted") {
  MapDoubt alike(20), poor(20);
  drive(alike, 60, kRight, false);
  CHECK_FALSE(alike.stands());
  for (int k = 0; k < 5; ++k) {
    drive(poor, 18, kPoor, false);
    drive(poor, 1, kPoor, true);
  }
  CHECK_FALSE(poor.stands());
}

TEST_CASE("a doubt ends when a place has been localized for as long as none was") {
  MapDoubt doubt(20);
  drive(doubt, 30, kPoor, false);
  drive(doubt, 19, kRight, true);
  CHECK_THAT(doubt.words(), Catch::Contains("no place held for 30 pieces"));
  drive(doubt, 2, kRight, true);
  CHECK(doubt.words().empty());
}

TEST_CASE("a map that says nothing of the beams is not doubted, and a new drive begins without a doubt") {
  MapDoubt silent(20), cleared(20);
  drive(silent, 60, kSilent, false);
  CHECK_FALSE(silent.stands());
  drive(cleared, 30, kPoor, false);
  cleared.clear();
  drive(cleared, 19, kPoor, false);
  CHECK_FALSE(cleared.stands());
}

TEST_CASE("a sensor description that is wrong explains what a map does not") {
  Answer answer;
  Circumstances poor;
  poor.agreement = {0.4, 0.4};
  const std::vector<Live> alike{hypothesis(1, kHere, 1), hypothesis(2, kThere, 1)};
  for (int k = 0; k < 25; ++k) answer.to(alike, poor);
  CHECK_FALSE(answer.estimator.map_doubt().empty());
  answer.estimator.contradict("the laser is mounted backwards");
  for (int k = 0; k < 25; ++k) answer.to(alike, poor);
  CHECK(answer.estimator.map_doubt().empty());
}
