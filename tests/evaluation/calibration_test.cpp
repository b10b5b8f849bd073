#include "tests/report/page_parts.hpp"

#include <opal/common/error.hpp>
#include "evaluation/calibration_page.hpp"

#include <catch2/catch.hpp>

#include <random>

using namespace opal;

namespace {

/// Statements that come true as often as they say.
std::vector<Statement> honest_statements(int count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Statement> statements;
  for (int k = 0; k < count; ++k) {
    const double p = uniform(random);
    statements.push_back({"query-" + std::to_string(k % 200), p, uniform(random) < p});
  }
  return statements;
}

}  // namespace

TEST_CASE("who says what comes true has no calibration error, and the Brier score of the outcomes themselves") {
  const Calibration c = calibration_of(honest_statements(200'000), Weighting::per_statement);
  CHECK(c.expected_error < 0.005);
  CHECK(c.reliability < 1e-4);
  CHECK(c.brier == Approx(1.0 / 6).margin(0.002));  // mean of p (1 - p) for p in [0, 1]
  CHECK(c.log_loss == Approx(0.5).margin(0.005));   // mean of -p log p - (1 - p) log(1 - p)
  CHECK(c.brier_within.low < c.brier);
  CHECK(c.brier_within.high > c.brier);
}

TEST_CASE("the parts of the Brier score add up") {
  std::vector<Statement> statements = honest_statements(500);
  for (std::size_t k = 0; k < statements.size(); k += 3) statements[k].probability = 0.999;
  for (const Weighting weighting : {Weighting::per_statement, Weighting::per_cluster}) {
    const Calibration c = calibration_of(statements, weighting);
    CHECK(c.brier == Approx(c.reliability - c.resolution + c.uncertainty + c.within_bins));
    CHECK(std::abs(c.within_bins) < 0.01);
  }
}

TEST_CASE("who is sure and wrong pays for it") {
  const std::vector<Statement> statements{{"a", 1, true}, {"a", 1, false}, {"b", 1, true}, {"b", 1, true}};
  const Calibration c = calibration_of(statements, Weighting::per_statement);
  CHECK(c.brier == Approx(0.25));
  CHECK(c.expected_error == Approx(0.25));
  CHECK(c.reliability == Approx(0.0625));
  CHECK(c.log_loss == Approx(0.25 * -std::log(1e-9)));
  REQUIRE(c.bins.size() == 1);
  CHECK(c.bins[0].statements == 4);
  CHECK(c.bins[0].clusters == 2);
  CHECK(c.bins[0].came_true == 0.75);
}

TEST_CASE("by query, a long query counts no more than a short one") {
  std::vector<Statement> statements(99, {"long", 0.95, true});
  statements.push_back({"short", 0.95, false});
  CHECK(calibration_of(statements, Weighting::per_statement).came_true == Approx(0.99));
  CHECK(calibration_of(statements, Weighting::per_cluster).came_true == Approx(0.5));
}

TEST_CASE("correlated rows do not make an interval narrow") {
  std::vector<Statement> alone, repeated;
  for (int query = 0; query < 20; ++query)
    for (int row = 0; row < 50; ++row) {
      const Statement statement{"q" + std::to_string(query), 0.8, query % 5 != 0};
      if (row == 0) alone.push_back(statement);
      repeated.push_back(statement);
    }
  const Interval few = calibration_of(alone, Weighting::per_statement).brier_within;
  const Interval many = calibration_of(repeated, Weighting::per_statement).brier_within;
  CHECK(many.high - many.low == Approx(few.high - few.low));
}

TEST_CASE("Wilson's interval holds the share, and stays within 0 and 1") {
  CHECK(wilson_interval(1, 10).high == Approx(1));
  CHECK(wilson_interval(1, 10).high <= 1);
  CHECK(wilson_interval(1, 10).low == Approx(0.7225).margin(0.001));
  CHECK(wilson_interval(0, 10).low == 0);
  CHECK(wilson_interval(0.5, 100).low == Approx(0.4038).margin(0.001));
}

TEST_CASE("nothing said, or no probability, is an error") {
  CHECK_THROWS_AS(calibration_of({}, Weighting::per_statement), ConfigError);
  CHECK_THROWS_WITH(calibration_of(std::vector<Statement>{{"q7", 1.5, true}}, Weighting::per_statement),
                    Catch::Contains("q7") && Catch::Contains("1.5"));
}

TEST_CASE("the page has the diagram of all probabilities and of those near 1, and every bin as text") {
  const Calibration c = calibration_of(honest_statements(1000), Weighting::per_statement);
  const std::string page = calibration_page("1000 rows", std::vector<CalibrationChapter>{{"a <title>", c, c}});
  CHECK(occurrences(page, "<div class=\"plot\"") == 4);  // reliability and counts, twice
  CHECK_THAT(page,
             Catch::Contains("a &lt;title&gt;") && Catch::Contains("1000 rows") && Catch::Contains("Brier score"));
  for (const std::vector<Cell>& row : table_of(c).rows)
    for (const Cell& cell : row) CHECK_THAT(page, Catch::Contains(">" + cell.text + "<"));
}
