#include "simulated_experiment.hpp"

#include "tests/report/page_parts.hpp"

#include "benchmark/verdict/quantity_words.hpp"
#include "benchmark/verdict_page/paper.hpp"
#include "benchmark/verdict_page/report_page.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

using namespace opal::statistics;
using Catch::Contains;

namespace {

ReportPage page_of(const SimulatedExperiment& experiment) {
  ReportPage page;
  page.title = "evidence <against> lack_of_fit";
  page.table = simulate(experiment, 11);
  for (ResultRow& row : page.table)
    if (row.arm == "b" && row.query == "q3") row.failure = "crashed: signal 11 & <core>";
  ComparisonOptions options = simulated_comparison();
  options.bootstrap_samples = 200;
  page.verdicts = compare(page.table, options);
  page.configuration = "{\n \"arms\": [\"a\", \"b\"]\n}";
  page.versions = {{"opal", "0.1.0", "5f2c"}, {"score_evidence", "0.1.0", "77ab"}};
  page.command = "opal ab experiment.jsonld -o out";
  page.link = [](const ResultRow& row) {
    return row.cluster == "site0" ? "" : "runs/" + row.arm + "/" + row.cluster + "/" + row.query + ".html?a=1&b=2";
  };
  return page;
}

}  // namespace

TEST_CASE("the page has the sentence, the links, the failures and what it takes to run it again") {
  const ReportPage page = page_of({kRecordedSites});
  const std::string html = to_html(page);
  CHECK_THAT(html, Contains(page.verdicts[0].sentence.substr(0, 40)));
  CHECK_THAT(html, Contains("href=\"runs/b/site1/q0.html?a=1&amp;b=2\""));
  CHECK_THAT(html, Contains("href=\"runs/a/site1/q0.html?a=1&amp;b=2\""));
  CHECK_THAT(html, !Contains("site0/q0.html"));
  CHECK_THAT(html, Contains("crashed: signal 11 &amp; &lt;core&gt;"));
  CHECK_THAT(html, Contains("opal ab experiment.jsonld -o out") && Contains("77ab"));
  CHECK(occurrences(html, "<div class=\"plot\"") ==
        5);  // a forest for each metric, a scatter for the distance and the cost
}

TEST_CASE("a summary comes first, and what differs before what does not") {
  ReportPage page = page_of({kRecordedSites});
  for (ResultRow& row : page.table) row.values.at(page.verdicts[0].metrics[0].metric.name) = 1;
  for (ResultRow& row : page.table) row.failure.clear();
  page.verdicts = compare(page.table, simulated_comparison());
  const MetricResult& alike = page.verdicts[0].metrics[0];
  const std::string html = to_html(page);
  const auto table = html.find("<table"), plot = html.find("<div class=\"plot\"");
  REQUIRE(table != std::string::npos);
  CHECK(table < plot);
  CHECK_THAT(html, Contains("No pair differs"));
  CHECK_THAT(html, Contains("in both arms, in all " + std::to_string(alike.pairs) + " pairs"));
}

TEST_CASE(
    "a forest plot for papers leaves out sites without bounds, and is left out without any other; tables have all") {
  namespace fs = std::filesystem;
  const opal::TemporaryFolder folder;
  ReportPage page = page_of({kRecordedSites});
  MetricResult& distance = page.verdicts[0].metrics[1];
  REQUIRE(distance.metric.kind == Metric::Kind::distance_until);
  const Interval none{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const std::string prefix = "/b_a_" + distance.metric.name + "_sites";
  const auto size_of_figure = [&](const std::string& name) {
    write_paper(page, folder.path_of(name));
    const std::string file = folder.path_of(name) + prefix;
    CHECK(fs::exists(file + ".csv"));
    return fs::exists(file + ".svg") ? fs::file_size(file + ".svg") : 0;
  };
  const auto all = size_of_figure("all");
  for (ClusterResult& cluster : distance.clusters) cluster.effect.interval = none;
  distance.effect.interval = {-1, 1};
  const auto total = size_of_figure("total");
  CHECK(total > 0);
  CHECK(total < all);
  distance.effect.interval = none;
  CHECK(size_of_figure("none") == 0);
}

TEST_CASE("a summary has signed numbers, each with its interval in the same direction") {
  MetricResult less, sooner;
  less.metric = {"cpu_ms", Metric::Kind::cost, false, "ms", "CPU", 0};
  less.effect = {2, 1.76, 0.88, {0.85, 0.91}};
  CHECK(signed_size_text(less) == "-12 %");
  CHECK(signed_interval_text(less) == "-15 to -9");
  sooner.metric = {"first_fix_m", Metric::Kind::distance_until, false, "m", "", 0};
  sooner.effect = {2, 1, -0.42, {-0.6, -0.3}};
  CHECK(signed_size_text(sooner) == "-0.42 m");
  CHECK(signed_interval_text(sooner) == "-0.60 to -0.30");
}

TEST_CASE("nothing in results becomes markup, and nothing is fetched") {
  ReportPage page = page_of({kRecordedSites});
  for (ResultRow& row : page.table) row.cluster = "<script>alert('" + row.cluster + "')</script>\"onload=";
  page.verdicts = compare(page.table, simulated_comparison());
  const std::string html = to_html(page);
  CHECK(occurrences(html, "<script") ==
        occurrences(html, "<div class=\"plot\"") + 1);  // their data, and what draws them
  CHECK(occurrences(html, "<script>") == 0);
  CHECK_THAT(html, !Contains("<link") && !Contains("<img") && !Contains("url("));
  CHECK_THAT(html, Contains("&lt;against&gt;"));
  CHECK_THAT(html, !Contains("\"onload"));
}

TEST_CASE("a page of odd results has no number that is none") {
  for (const std::vector<std::size_t>& sites :
       {std::vector<std::size_t>{1}, std::vector<std::size_t>{2, 2}, std::vector<std::size_t>(8, 1)}) {
    const std::string html = without_drawing(to_html(page_of({sites})));
    CHECK_THAT(html, !Contains("nan") && !Contains("\"inf") && !Contains("-inf"));
  }
  CHECK_THAT(to_html({}), Contains("Every run came to its end"));
}

TEST_CASE("a page to look at: OPAL_REPORT_PAGE names the file", "[.][look]") {
  const char* file = std::getenv("OPAL_REPORT_PAGE");
  REQUIRE(file != nullptr);
  SimulatedExperiment experiment{kRecordedSites};
  experiment.planted = 0.5;
  experiment.cost_ratio = 1.12;
  std::ofstream(file) << to_html(page_of(experiment));
}
