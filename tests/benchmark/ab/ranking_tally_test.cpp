#include "benchmark/ab/records/ranking_tally.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace opal::ab;

namespace {

std::map<std::string, double> values_of(const std::vector<std::vector<RankedHypothesis>>& scans) {
  RankingTally tally;
  for (const auto& scan : scans) tally.add(scan);
  return tally.values();
}

}  // namespace

TEST_CASE("a scan without a right and a wrong hypothesis is no contest") {
  CHECK(values_of({{}, {{1, true}}, {{1, false}, {2, false}}}).empty());
}

TEST_CASE("ranking is by the best right and the best wrong hypothesis") {
  const auto values = values_of({{{2, true}, {1, false}, {0, true}}, {{0, true}, {3, false}}, {{5, true}}});
  CHECK(values.at("contests") == 2);
  CHECK(values.at("top_share") == Approx(0.5));
  CHECK(values.at("on_top") == 0);
  CHECK(values.at("margin_nat") == Approx((1 - 3) / 2.0));
  const double first = (std::exp(2) + 1) / (std::exp(2) + std::exp(1) + 1), second = 1 / (1 + std::exp(3));
  CHECK(values.at("log_loss_nat") == Approx(-(std::log(first) + std::log(second)) / 2));
  CHECK(values.at("surprise") == Approx(std::exp(values.at("log_loss_nat"))));
}

TEST_CASE("those that share the top count by their share") {
  CHECK(values_of({{{1, true}, {1, false}, {1, false}, {0, true}}}).at("top_share") == Approx(1 / 3.0));
}

TEST_CASE("scores that differ absurdly count no more than 10 nat, and no score overflows") {
  const auto values = values_of({{{-1e300, true}, {1e300, false}}});
  CHECK(values.at("margin_nat") == -10);
  CHECK(values.at("log_loss_nat") == 10);
}

TEST_CASE("the same number added to all scores changes nothing") {
  const auto values = values_of({{{2, true}, {1, false}}}), shifted = values_of({{{52, true}, {51, false}}});
  for (const auto& [name, value] : values) CHECK(shifted.at(name) == Approx(value));
}
