#include "benchmark/statistics/alpha_spending.hpp"
#include "benchmark/statistics/cluster_bootstrap.hpp"
#include "benchmark/statistics/holm.hpp"
#include "benchmark/statistics/mcnemar.hpp"
#include "benchmark/statistics/sign_flip.hpp"
#include "benchmark/statistics/wilcoxon.hpp"

#include <opal/common/error.hpp>

#include <boost/math/distributions/normal.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace opal::statistics;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double bound_of(double level) { return quantile(complement(boost::math::normal(), level / 2)); }

}  // namespace

TEST_CASE("O'Brien and Fleming's bounds as published for this spending function") {
  // Lan & DeMets (1983) as tabulated in Reboussin et al. (2000): five and three looks, level 0.05, two-sided.
  const std::vector<double> five{4.8769, 3.3569, 2.6803, 2.2898, 2.0310}, three{3.7103, 2.5114, 1.9930};
  for (int look = 1; look <= 5; ++look)
    CHECK(bound_of(look_level(0.05, look, 5)) == Approx(five[static_cast<std::size_t>(look - 1)]).margin(2e-4));
  for (int look = 1; look <= 3; ++look)
    CHECK(bound_of(look_level(0.05, look, 3)) == Approx(three[static_cast<std::size_t>(look - 1)]).margin(2e-4));
  CHECK(look_level(0.05, 1, 1) == Approx(0.05));
  CHECK_THROWS_AS(look_level(0.05, 3, 2), opal::Error);
  CHECK_THROWS_AS(look_levels(0.05, std::vector<double>{0.5, 0.5}), opal::Error);
}

TEST_CASE("ranks: ties share theirs, zeros take part and weigh nothing, infinite comes last") {
  CHECK(signed_ranks(std::vector<double>{0, -2, 2, kInfinite, -kInfinite, 1}) ==
        std::vector<double>{0, -3.5, 3.5, 5.5, -5.5, 2});
  CHECK(wilcoxon(std::vector<double>{}).p == 1);
  CHECK(wilcoxon(std::vector<double>{0, 0, 0}).p == 1);
  CHECK(wilcoxon(std::vector<double>{1, 2, 3, 4, 5, 6}).p == Approx(2.0 / 64));
}

TEST_CASE("sign flips: by enumeration, by halves and by drawing") {
  CHECK(sign_flip_test(std::vector<double>{}) == 1);
  CHECK(sign_flip_test(std::vector<double>{1, 1, 1, 1, 1, 1}) == Approx(2.0 / 64));
  CHECK(sign_flip_test(std::vector<double>{1, -1}) == 1);
  // Fair coins, 20 of 30 and 40 of 60: binomial tails.
  std::vector<double> thirty(30, 1.0), sixty(60, 1.0);
  std::fill_n(thirty.begin(), 10, -1.0);
  std::fill_n(sixty.begin(), 20, -1.0);
  CHECK(sign_flip_test(thirty) == Approx(0.098737).margin(1e-6));
  CHECK(sign_flip_test(sixty) == Approx(0.013489).margin(0.004));
}

TEST_CASE("the bootstrap draws whole clusters, or pairs within each") {
  const std::vector<std::size_t> sizes{3, 2};
  const auto clusters_are_whole = [](const Weights& w) {
    return w[0] == w[1] && w[1] == w[2] && w[3] == w[4] && w[0] + w[3] == 2 ? 1.0 : 0.0;
  };
  const auto sizes_are_kept = [](const Weights& w) { return w[0] + w[1] + w[2] == 3 && w[3] + w[4] == 2 ? 1.0 : 0.0; };
  for (const double good : bootstrap(sizes, clusters_are_whole, {50, 1, true})) CHECK(good == 1);
  for (const double good : bootstrap(sizes, sizes_are_kept, {50, 1, false})) CHECK(good == 1);
  const Statistic first = [](const Weights& w) { return static_cast<double>(w[0]); };
  CHECK(bootstrap(sizes, first, {50, 1, true}) == bootstrap(sizes, first, {50, 1, true}));
  CHECK(bootstrap(sizes, first, {50, 1, true}) != bootstrap(sizes, first, {50, 2, true}));
}

TEST_CASE("no pair differs: nothing is told, and the interval of the difference still has a width") {
  const PairedCounts none{90, 0, 0, 8};
  CHECK(mcnemar(none).exact == 1);
  CHECK(mcnemar(none).mid == 1);
  CHECK(std::isnan(matched_odds_ratio(none)));
  const Interval interval = difference_interval(none, 0.05);
  CHECK(interval.high == Approx(-interval.low));
  CHECK(interval.high == Approx(0.0196).margin(1e-3));
  CHECK(difference_interval({}, 0.05).high <= 1);
}

TEST_CASE("Holm leaves one p-value alone and never changes their order") {
  CHECK(holm(std::vector<double>{0.03}) == std::vector<double>{0.03});
  CHECK(holm(std::vector<double>{0.04, 0.01, 0.03}) == std::vector<double>{0.06, 0.03, 0.06});
  CHECK(holm(std::vector<double>{}).empty());
}
