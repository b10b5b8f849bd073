#include "benchmark/experiments/kit/order_statistics.hpp"

#include "common/random.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include <algorithm>

using namespace opal;
using namespace opal::experiments;

TEST_CASE("the median of runs that did not all arrive") {
  CHECK(median({}) == kNever);
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({3, kNever, 2, 1}) == 2.5);
  CHECK(median({3, kNever, kNever, 1}) == kNever);
}

TEST_CASE("the interval of a median lies between the order statistics of the sign test") {
  std::vector<double> values;
  for (int k = 1; k <= 20; ++k) values.push_back(k);
  // Binomial(20, 1/2): P(at most 5) = 0.0207, P(at most 6) = 0.0577 (Conover 1999, table A3).
  CHECK(median_interval(values).low == 6);
  CHECK(median_interval(values).high == 15);
  CHECK(median_interval({1, 2, 3, 4, 5}).low == 1);
  CHECK(median_interval({1, 2, 3, 4, 5}).high == 5);
  CHECK(median_interval({}).low == kNever);
}

TEST_CASE("the interval of a median holds it in at least 95 of 100 samples") {
  Random random(7);
  constexpr int kSamples = 4000;
  int held = 0;
  for (int sample = 0; sample < kSamples; ++sample) {
    std::vector<double> values;
    for (int k = 0; k < 20; ++k) values.push_back(std::exp(random.normal(1)));
    const Interval within = median_interval(values);
    held += within.low <= 1 && 1 <= within.high;
  }
  CHECK(held > 0.95 * kSamples);
  CHECK(held < 0.97 * kSamples);  // and is no wider than it has to be: 95.9 % for 20 values
}

TEST_CASE("the interval of a median of many values lies about it") {
  const int count = GENERATE(1000, 1074, 1075, 5000);
  CAPTURE(count);
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(k);
  const Interval within = median_interval(values);
  const double half = 0.98 * std::sqrt(count);  // 1.96 of a binomial's standard deviations
  CHECK(within.low == Approx((count - 1) / 2. - half).margin(2));
  CHECK(within.high == Approx((count - 1) / 2. + half).margin(2));
}

TEST_CASE("a share is told with Wilson's interval") {
  CHECK(share_text(20, 20) == "20 of 20, 100.0 % (95 %: 83.9 to 100.0)");
  CHECK(share_text(0, 0) == "none of 0");
}
