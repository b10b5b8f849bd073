#include "benchmark/verdict/comparison.hpp"
#include "benchmark/verdict/verdict_sentence.hpp"

#include <catch2/catch.hpp>

#include <limits>

using namespace opal::statistics;
using Catch::Contains;

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// So many queries of a site of which only b, only a, or both succeed; the others fail in both.
struct Site {
  std::string name;
  int queries = 0, only_b = 0, only_a = 0, both = 0;
};

/// @param metres  how much sooner b is where both get there. @param ratio  of costs, b to a, spread by 1 % over the
/// sites.
ResultsTable results(const std::vector<Site>& sites, double metres, double ratio) {
  ResultsTable table;
  for (std::size_t i = 0; i < sites.size(); ++i)
    for (int query = 0; query < sites[i].queries; ++query) {
      const Site& site = sites[i];
      const bool b = query < site.both + site.only_b;
      const bool a =
          query < site.both || (query >= site.both + site.only_b && query < site.both + site.only_b + site.only_a);
      const auto add = [&](const std::string& arm, bool success, double distance_m, double cpu_ms) {
        table.push_back({arm,
                         site.name,
                         std::to_string(query),
                         1,
                         {{"success", success}, {"first_fix_m", success ? distance_m : kEndless}, {"cpu_ms", cpu_ms}},
                         ""});
      };
      add("A", a, 2, 1);
      add("B", b, 2 - metres, ratio * (1 + 0.01 * (static_cast<double>(i) / 7 + 0.1 * (query % 3))));
    }
  return table;
}

Verdict verdict_on(const ResultsTable& table, int look = 1, int looks = 1) {
  ComparisonOptions options;
  options.baseline = "A";
  options.metrics = {{"success", Metric::Kind::proportion, true, "", "localizes in", 0},
                     {"first_fix_m", Metric::Kind::distance_until, false, "m", "", 0},
                     {"cpu_ms", Metric::Kind::cost, false, "ms", "CPU", 0}};
  options.bootstrap_samples = 100;
  options.look = look;
  options.looks = looks;
  return compare(table, options).front();
}

/// Seven sites of 20 queries; b gets these more, a those, and both the rest.
std::vector<Site> seven(const std::vector<int>& only_b, const std::vector<int>& only_a) {
  std::vector<Site> sites;
  for (std::size_t i = 0; i < 7; ++i)
    sites.push_back({"site" + std::to_string(i + 1), 20, only_b[i], only_a[i], 20 - only_b[i] - only_a[i]});
  return sites;
}

}  // namespace

TEST_CASE("what is told: both values, difference, interval, and where") {
  const Verdict verdict = verdict_on(results(seven({3, 9, 4, 3, 10, 4, 3}, {0, 0, 0, 0, 0, 0, 0}), 0.4, 1.12));
  CHECK(verdict.sentence ==
        "B localizes in 100.0 % against 74.3 % (difference 25.7 points, 95 % interval 11.7 to 39.7), median 0.4 m "
        "sooner (95 % interval 0.4 "
        "to 0.4), 13 % more CPU (95 % interval 12 to 13); better on site2 and site5, no difference told elsewhere.");
}

TEST_CASE("what is worse and cheaper is said so") {
  const Verdict verdict = verdict_on(results(seven({0, 0, 0, 0, 0, 0, 0}, {5, 6, 4, 5, 6, 5, 6}), -1.2, 0.5));
  CHECK_THAT(verdict.sentence, Contains("B localizes in 73.6 % against 100.0 % (difference -26.4 points"));
  CHECK_THAT(verdict.sentence, Contains("median 1.2 m later"));
  CHECK_THAT(verdict.sentence, Contains("50 % less CPU"));
}

TEST_CASE("no verdict says how many more queries would tell what") {
  const Verdict verdict = verdict_on(results(seven({3, 0, 2, 1, 2, 0, 2}, {1, 1, 0, 1, 0, 1, 0}), 0, 1));
  CHECK(verdict.metrics[0].outcome == Outcome::open);
  CHECK_THAT(verdict.sentence,
             Contains("No verdict yet on success (97.1 % against 92.9 %, difference 4.3 points, 95 % interval"));
  CHECK_THAT(verdict.sentence, Contains("more queries, from ") && Contains("would tell a difference of 4.3 points"));
}

TEST_CASE("a difference that does not hold from site to site is no verdict, though pair by pair it would be") {
  const Verdict verdict = verdict_on(results(seven({14, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}), 0, 1));
  CHECK(verdict.metrics[0].p_pairs < 0.001);
  CHECK(verdict.metrics[0].outcome == Outcome::open);
  CHECK(verdict.metrics[0].clusters[0].outcome == Outcome::better);
  REQUIRE_FALSE(verdict.notes.empty());
  CHECK_THAT(verdict.notes[0], Contains("does not hold from site to site"));
}

TEST_CASE("a difference that only the correction for all comparisons denies is said so, with the corrected p") {
  Verdict verdict = verdict_on(results(seven({14, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}), 0, 1));
  verdict.metrics[0].p = 0.008;
  verdict.metrics[0].p_corrected = 0.073;
  const std::vector<std::string> notes = notes_of(verdict);
  REQUIRE_FALSE(notes.empty());
  CHECK(notes[0] ==
        "Alone, a difference in success would be told (p = 0.0080), but it does not hold after the correction for all "
        "comparisons of this experiment (p = 0.073).");
}

TEST_CASE("a cost that is hardly different is no difference to be expected") {
  const Verdict verdict = verdict_on(results(seven({3, 9, 4, 3, 10, 4, 3}, {0, 0, 0, 0, 0, 0, 0}), 0.4, 0.993));
  CHECK_THAT(verdict.sentence, Contains("No difference in CPU bigger than 0.5 % is to be expected"));
}

TEST_CASE("many ties: the median is none, the ranks tell, and the sentence counts") {
  ResultsTable table;
  for (int site = 0; site < 8; ++site)
    for (int query = 0; query < 10; ++query)
      for (const std::string arm : {"A", "B"}) {
        const double distance_m = query >= 4 + site % 2 ? 0 : arm == "A" ? 3 : 1;
        table.push_back({arm,
                         "s" + std::to_string(site),
                         std::to_string(query),
                         1,
                         {{"success", 1}, {"first_fix_m", distance_m}, {"cpu_ms", 1}},
                         ""});
      }
  const Verdict verdict = verdict_on(table);
  CHECK(verdict.metrics[1].outcome == Outcome::better);
  CHECK_THAT(verdict.sentence, Contains("sooner in 36 and later in 0 of 80 pairs"));
}

TEST_CASE("few sites are named as the scope, and looks in the notes") {
  const std::vector<Site> two{{"x", 30, 12, 0, 18}, {"y", 30, 10, 1, 19}};
  const Verdict verdict = verdict_on(results(two, 0.4, 1.3), 1, 2);
  CHECK_THAT(verdict.sentence, Contains("Said of these 2 sites only, with their queries taken as independent."));
  CHECK_THAT(verdict.sentence, Contains("99.69 % interval"));
  CHECK_THAT(verdict_on(results({two[0]}, 0.4, 1.3)).sentence,
             Contains("Said of this site only, with its queries taken as independent."));
  CHECK_THAT(verdict.notes[0], Contains("This is look 1 of 2"));
}

TEST_CASE("crashes are named and count as worse") {
  ResultsTable table = results(seven({0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}), 0, 1);
  for (ResultRow& row : table)
    if (row.arm == "B" && (row.query == "0" || row.query == "1" || row.query == "2"))
      row.failure = "timed out after 60 s";
  const Verdict verdict = verdict_on(table);
  CHECK(verdict.metrics[0].outcome == Outcome::worse);
  CHECK_THAT(verdict.notes[0], Contains("B did not run to the end in 21 of 140 runs"));
}

TEST_CASE("where an interval excludes no difference and there is no verdict, the sentence says why") {
  Verdict verdict = verdict_on(results(seven({3, 0, 2, 1, 2, 0, 2}, {1, 1, 0, 1, 0, 1, 0}), 0, 1));
  MetricResult& success = verdict.metrics[0];
  success.effect.interval = {0.01, 0.08};
  success.p = 0.02;
  success.p_corrected = 0.06;
  CHECK_THAT(sentence_of(verdict), Contains("alone it would be one (p = 0.02"));
  CHECK_THAT(sentence_of(verdict), Contains("corrected for all comparisons of this experiment p is 0.06"));
  success.p = success.p_corrected = 0.06;
  CHECK_THAT(sentence_of(verdict), Contains("the test decides, and says p = 0.06"));
  success.effect.interval = {-0.01, 0.08};
  CHECK_THAT(sentence_of(verdict), !Contains("the test decides") && !Contains("alone it would"));
}
