#include <catch2/catch.hpp>

#include "benchmark/experiments/buildings/building_share.hpp"
#include "benchmark/experiments/kit/order_statistics.hpp"

using namespace opal::experiments;

TEST_CASE("a share over buildings of one run each has Wilson's interval") {
  std::vector<Tally> buildings(40, {1, 1});
  for (int k = 0; k < 10; ++k) buildings[k].part = 0;
  const BuildingShare found = share_over(buildings);
  const opal::Interval wilson = opal::wilson_interval(0.75, 40);
  CHECK(found.share == 0.75);
  CHECK(found.within.low == Approx(wilson.low).epsilon(0.02));
  CHECK(found.within.high == Approx(wilson.high).epsilon(0.02));
}

TEST_CASE("runs that fail together say less than runs that fail apart") {
  std::vector<Tally> together(20, {10, 10}), apart(20, {9, 10});
  together[3].part = together[7].part = 0;
  const BuildingShare wide = share_over(together), narrow = share_over(apart);
  CHECK(wide.share == Approx(narrow.share));
  CHECK(wide.within.high - wide.within.low > 2 * (narrow.within.high - narrow.within.low));
}

TEST_CASE("a share of all or none has an interval of some width, and no run says nothing") {
  const std::vector<Tally> all(25, {14, 14}), none(25, {0, 14});
  CHECK(share_over(all).within.low < 1);
  CHECK(share_over(all).within.low > 0.98);
  CHECK(share_over(none).within.high > 0);
  CHECK(share_over({}).within.low == 0);
  CHECK(share_over({}).within.high == 1);
}

TEST_CASE("a median over buildings lies in its interval, whatever was never reached") {
  std::vector<std::vector<double>> buildings;
  for (int k = 0; k < 20; ++k) buildings.push_back({k * 0.1, k * 0.2, kNever});
  const BuildingMedian found = median_over(buildings);
  CHECK(found.within.low <= found.median);
  CHECK(found.median <= found.within.high);
  CHECK(median_over(std::vector<std::vector<double>>{{kNever, kNever, 1}}).median == kNever);
  CHECK(median_over({}).median == kNever);
  const BuildingMedian alone = median_over(std::vector<std::vector<double>>{{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}});
  CHECK(alone.within.low < alone.median);
  CHECK(alone.median < alone.within.high);
  CHECK(median_over(buildings).within.high == found.within.high);
}
