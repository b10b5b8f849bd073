#include "benchmark/verdict_page/report_page.hpp"

#include "benchmark/verdict/quantity_words.hpp"
#include "benchmark/verdict_page/report_tables.hpp"
#include "benchmark/verdict_page/verdict_plots.hpp"
#include "common/phrases.hpp"
#include "report/html_elements.hpp"

#include <fmt/format.h>

namespace opal::statistics {
namespace {

using Kind = Metric::Kind;

/// Longer tables are cut, and say so.
std::string cut_html(Table table, const std::string& rest, const std::string& if_empty) {
  constexpr std::size_t kShown = 200;
  const std::size_t rows = table.rows.size();
  if (rows == 0) return text_element("p", if_empty);
  if (rows <= kShown) return html_of(table);
  table.rows.resize(kShown, {});
  return html_of(table) + text_element("p", fmt::format("{} more {}.", rows - kShown, rest));
}

bool told(const Verdict& verdict) {
  for (const MetricResult& result : verdict.metrics)
    if (result.outcome == Outcome::better || result.outcome == Outcome::worse) return true;
  return false;
}

std::string verdict_html(const Verdict& verdict) {
  std::string notes;
  for (const std::string& note : verdict.notes) notes += text_element("li", note);
  const std::string arms = fmt::format("{} beside {}, {} queries on {}", verdict.arm, verdict.baseline, verdict.queries,
                                       count_of(verdict.clusters, "site"));
  return element("div",
                 "\n" + text_element("div", arms, "quiet") + text_element("p", verdict.sentence) +
                     html_of(summary_table(verdict)) + (notes.empty() ? "" : element("ul", "\n" + notes, "notes")),
                 told(verdict) ? "verdict told" : "verdict") +
         "\n";
}

std::string pairs_html(const PairedSample& sample, const MetricResult& result, const Verdict& verdict,
                       const LinkedRuns& links) {
  const std::string picture = result.metric.kind == Kind::proportion
                                  ? html_of(counts_table(result, verdict.arm, verdict.baseline))
                                  : scatter_html(sample, result.metric, verdict.arm, verdict.baseline, links);
  const Table differing = differing_table(sample, result.metric, verdict.arm, verdict.baseline, links);
  const std::string name = fmt::format("{}_{}_{}.csv", verdict.arm, verdict.baseline, result.metric.name);
  return element(
             "div",
             element("div", picture) + element("div", details("Queries that differ",
                                                              cut_html(differing, "differ less", "No pair differs.") +
                                                                  download(name, csv_of(differing)),
                                                              true)),
             "side") +
         "\n";
}

std::string metric_html(const ReportPage& page, const MetricResult& result, const Verdict& verdict,
                        const LinkedRuns& links) {
  const std::string title = text_element("h3", name_in_words(result.metric));
  const PairedSample sample = pair_rows(page.table, result.metric, verdict.baseline, verdict.arm);
  return element("section", title + forest_html(result, verdict.arm, verdict.baseline) +
                                pairs_html(sample, result, verdict, links)) +
         "\n";
}

/// Metrics in which no pair differs have no picture.
std::string alike_html(const Verdict& verdict) {
  std::string html;
  for (const MetricResult& result : verdict.metrics)
    if (!differs(result))
      html += text_element(
          "li", result.pairs == 0
                    ? name_in_words(result.metric) + ": no query has a value of both"
                    : fmt::format("{}: {} in both arms, in all {}", name_in_words(result.metric),
                                  value_text(result.metric, result.effect.b), count_of(result.pairs, "pair")));
  return html.empty() ? "" : element("section", text_element("h3", "No pair differs") + element("ul", html)) + "\n";
}

std::string key_html() {
  return colour_key({{"good", "better"},
                     {"bad", "worse"},
                     {"equal", "no difference of interest"},
                     {"open", "not told"},
                     {"a", "opens the baseline's run"},
                     {"b", "opens the other arm's run"}}) +
         text_element(
             "p",
             "Differences are of the second arm to the baseline; what is told is corrected after Holm. Squares: "
             "one site by itself, its queries taken as independent. Diamond: all. Beyond the dashed lines of a "
             "scatter: never reached.",
             "quiet");
}

std::string comparison_html(const ReportPage& page, const Verdict& verdict, const LinkedRuns& links) {
  const std::string name = verdict.arm + " beside " + verdict.baseline;
  const Table numbers = numbers_table(verdict);
  std::string html = text_element("h2", name) + key_html();
  for (const MetricResult& result : verdict.metrics)
    if (differs(result)) html += metric_html(page, result, verdict, links);
  return html + alike_html(verdict) +
         element(
             "section",
             text_element("h3", "All numbers") + html_of(numbers) + download(name + ".csv", csv_of(numbers)) +
                 text_element("p",
                              "p decides. With three sites or more it is Student's t between sites (of differences, "
                              "signed ranks of distances, logarithms of costs; variance after Bell and McCaffrey); "
                              "with fewer, pairs are taken as independent: McNemar (mid-p), Wilcoxon, t of "
                              "logarithms. Sign flips and bootstrap are for comparison; with few sites the bootstrap "
                              "is too narrow. Opal's docs/ab_statistics.md says why.",
                              "quiet")) +
         "\n";
}

std::string rerun_html(const ReportPage& page) {
  const std::string command =
      page.command.empty() ? "" : text_element("p", "With the versions below:") + text_element("pre", page.command);
  return text_element("h2", "How to run it again") +
         element("section", command + html_of(versions_table(page.versions)) +
                                details("The whole configuration", text_element("pre", page.configuration))) +
         "\n";
}

}  // namespace

std::string to_html(const ReportPage& page) {
  const LinkedRuns links(page);
  std::string html;
  for (const Verdict& verdict : page.verdicts) html += verdict_html(verdict);
  for (const Verdict& verdict : page.verdicts) html += comparison_html(page, verdict, links);
  html += text_element("h2", "Failures") +
          element("section", cut_html(failures_table(page.table, links), "failed", "Every run came to its end."));
  return html_page(page.title, html + rerun_html(page));
}

}  // namespace opal::statistics
