#include <opal/common/quantile.hpp>

#include <catch2/catch.hpp>

#include <limits>

using namespace opal;

namespace {
constexpr double kInfinite = std::numeric_limits<double>::infinity();
}

TEST_CASE("a quantile lies between two values as its share does between their ranks") {
  const std::vector<double> sorted{1, 2, 4, 8, 16};
  CHECK(quantile_of(sorted, 0) == 1);
  CHECK(quantile_of(sorted, 0.25) == 2);
  CHECK(quantile_of(sorted, 0.625) == 6);
  CHECK(quantile_of(sorted, 1) == 16);
  CHECK(quantile_of(sorted, -1) == 1);
  CHECK(quantile_of(sorted, 2) == 16);
}

TEST_CASE("quantiles of numbers of which some are infinite") {
  const std::vector<double> sorted{-kInfinite, 0, 1, kInfinite};
  CHECK(quantile_of(sorted, 0.5) == 0.5);
  CHECK(quantile_of(sorted, 0.1) == -kInfinite);
  CHECK(quantile_of(sorted, 0.9) == kInfinite);
}

TEST_CASE("a median is the middle value, or the mean of the two in the middle") {
  CHECK(median_of({3, 1, 2}) == 2);
  CHECK(median_of({4, 1, 2, 3}) == 2.5);
  CHECK(median_of({1, kInfinite, 2, kInfinite}) == kInfinite);
}

TEST_CASE("no values have no quantile and no median") {
  CHECK_FALSE(quantile_of({}, 0.5));
  CHECK_FALSE(median_of({}));
}

TEST_CASE("an upper median is the value in the middle, the greater one of two") {
  CHECK(upper_median_of({3, 1, 2}) == 2);
  CHECK(upper_median_of({4, 1, 3, 2}) == 3);
  CHECK(upper_median_of({7}) == 7);
}
