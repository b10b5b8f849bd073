#include "benchmark/verdict_page/report_page.hpp"

#include "benchmark/verdict/quantity_words.hpp"
#include "benchmark/verdict_page/forest_plot.hpp"
#include "benchmark/verdict_page/report_tables.hpp"
#include "benchmark/verdict_page/scatter_plot.hpp"
#include "report/html_text.hpp"

namespace opal::statistics {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light; --text: #292e38; --faint: #5b6371; --line: #d9dce1; --a: #1a6bd1; --b: #a85200; --good: #05804d; --bad: #b3261e; }
* { box-sizing: border-box; }
body { max-width: 1080px; margin: 0 auto; padding: 24px; color: var(--text); background: #f7f6f3;
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif; }
h1 { font-size: 24px; margin: 0 0 16px; } h2 { font-size: 19px; margin: 36px 0 8px; } h3 { font-size: 15px; margin: 20px 0 6px; }
section, .verdict { background: #fff; border: 1px solid var(--line); border-radius: 6px; padding: 14px 18px; margin: 0 0 14px; }
.verdict p:first-of-type { font-size: 18px; line-height: 1.45; margin: 2px 0 8px; }
.verdict { border-left: 6px solid var(--faint); } .verdict.told { border-left-color: var(--a); }
.arms, .quiet { color: var(--faint); } .notes { margin: 0; padding-left: 20px; color: var(--faint); }
.wide { overflow-x: auto; } h3:first-child { margin-top: 0; } table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 3px 12px 3px 0; border-bottom: 1px solid var(--line); white-space: nowrap; } th { color: var(--faint); font-weight: 600; }
pre { overflow-x: auto; font: 12px/1.45 ui-monospace, Menlo, Consolas, "DejaVu Sans Mono", monospace; background: #f7f6f3; padding: 10px; border-radius: 4px; }
a { color: var(--a); } summary { cursor: pointer; color: var(--a); }
svg { width: 100%; height: auto; display: block; font-size: 13px; } svg.scatter { max-width: 520px; }
svg text { fill: var(--text); } svg text.quiet { fill: var(--faint); } .middle { text-anchor: middle; } .end { text-anchor: end; }
svg line { stroke: var(--line); } svg line.none { stroke: var(--faint); stroke-dasharray: 4 3; } svg line.never { stroke: var(--bad); stroke-dasharray: 3 3; }
svg line.whisker { stroke: var(--text); stroke-width: 1.5; } svg .arrow { fill: var(--text); } svg .frame { fill: none; stroke: var(--line); }
svg .total text { font-weight: 650; } svg .better { fill: var(--good); } svg .worse { fill: var(--bad); } svg .equal { fill: #71809a; } svg .open { fill: var(--text); }
svg .of-a { fill: var(--a); } svg .of-b { fill: var(--b); } svg .of-a, svg .of-b { fill-opacity: .75; } svg a:hover path { fill-opacity: 1; stroke: #000; }
.plots { display: flex; flex-wrap: wrap; gap: 24px; align-items: flex-start; } .plots > * { flex: 1 1 420px; min-width: 0; } details .wide { max-height: 420px; overflow: auto; }
.key b { font-weight: 650; } .key .better { color: var(--good); } .key .worse { color: var(--bad); } .key .a { color: var(--a); } .key .b { color: var(--b); }
)";

using Kind = Metric::Kind;

/// Styles, and links that the caller gives: nothing is fetched and nothing runs.
std::string head(const std::string& title) {
  return "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
         "base-uri 'none'; form-action 'none'\">\n"
         "<title>" +
         html_text(title) + "</title>\n<style>" + kStyle + "</style>\n<h1>" + html_text(title) + "</h1>\n";
}

bool told(const Verdict& verdict) {
  for (const MetricResult& result : verdict.metrics)
    if (result.outcome == Outcome::better || result.outcome == Outcome::worse) return true;
  return false;
}

std::string verdict_html(const Verdict& verdict) {
  std::string html = "<div class=\"verdict" + std::string(told(verdict) ? " told" : "") + "\">\n<div class=\"arms\">" +
                     html_text(verdict.arm) + " beside " + html_text(verdict.baseline) + ", " +
                     std::to_string(verdict.queries) + " queries on " + std::to_string(verdict.clusters) +
                     (verdict.clusters == 1 ? " site" : " sites") + "</div>\n<p>" + html_text(verdict.sentence) +
                     "</p>\n";
  if (verdict.notes.empty()) return html + "</div>\n";
  html += "<ul class=\"notes\">\n";
  for (const std::string& note : verdict.notes) html += "<li>" + html_text(note) + "</li>\n";
  return html + "</ul></div>\n";
}

std::string pairs_html(const PairedSample& sample, const MetricResult& result, const Verdict& verdict,
                       const LinkedRuns& links) {
  const bool proportion = result.metric.kind == Kind::proportion;
  const std::string picture =
      proportion ? "" : scatter_plot(sample, result.metric, verdict.arm, verdict.baseline, links);
  const std::string counts = proportion ? counts_table(result, verdict.arm, verdict.baseline) : "";
  const std::string costs = result.metric.kind == Kind::cost ? cost_table(result, verdict.arm, verdict.baseline) : "";
  return "<div class=\"plots\"><div>" + picture + counts + "</div><div>" + costs +
         "<details open><summary>Queries that differ</summary>\n" +
         differing_table(sample, result.metric, verdict.arm, verdict.baseline, links) + "</details></div></div>\n";
}

std::string metric_html(const ReportPage& page, const MetricResult& result, const Verdict& verdict,
                        const LinkedRuns& links) {
  const std::string title = "<section><h3>" + html_text(name_in_words(result.metric)) + "</h3>\n";
  if (result.pairs == 0) return title + "<p>No query has a value of both.</p></section>\n";
  const PairedSample sample = pair_rows(page.table, result.metric, verdict.baseline, verdict.arm);
  return title + forest_plot(result, verdict.arm, verdict.baseline) + pairs_html(sample, result, verdict, links) +
         "</section>\n";
}

std::string key_html() {
  return "<p class=\"key quiet\">Differences are of the second arm to the baseline. Squares: one site by itself, its "
         "queries taken as independent. Diamond: all. "
         "<b class=\"better\">Green</b>: better, <b class=\"worse\">red</b>: worse, dark: not told; corrected after "
         "Holm. Dots of the scatter: "
         "<b class=\"a\">left half</b> opens the baseline's run, <b class=\"b\">right half</b> the other arm's; beyond "
         "the dashed lines: never reached.</p>\n";
}

std::string comparison_html(const ReportPage& page, const Verdict& verdict, const LinkedRuns& links) {
  std::string html =
      "<h2>" + html_text(verdict.arm) + " beside " + html_text(verdict.baseline) + "</h2>\n" + key_html();
  for (const MetricResult& result : verdict.metrics) html += metric_html(page, result, verdict, links);
  return html + "<section><h3>All numbers</h3>\n" + numbers_table(verdict) +
         "<p class=\"quiet\">p decides. With three sites or more it is Student's t between sites (of differences, "
         "signed ranks of distances, logarithms of costs; "
         "variance after Bell and McCaffrey); with fewer, pairs are taken as independent: McNemar (mid-p), Wilcoxon, t "
         "of logarithms. Sign flips and "
         "bootstrap are for comparison; with few sites the bootstrap is too narrow. Opal's docs/ab_statistics.md says "
         "why.</p></section>\n";
}

std::string rerun_html(const ReportPage& page) {
  const std::string command =
      page.command.empty() ? "" : "<p>With the versions below:</p><pre>" + html_text(page.command, true) + "</pre>\n";
  return "<h2>How to run it again</h2>\n<section>" + command + versions_table(page.versions) +
         "<details><summary>The whole configuration</summary><pre>" + html_text(page.configuration, true) +
         "</pre></details></section>\n";
}

}  // namespace

std::string to_html(const ReportPage& page) {
  const LinkedRuns links(page);
  std::string html = head(page.title);
  for (const Verdict& verdict : page.verdicts) html += verdict_html(verdict);
  for (const Verdict& verdict : page.verdicts) html += comparison_html(page, verdict, links);
  html += "<h2>Failures</h2>\n<section>" + failures_table(page.table, links) + "</section>\n";
  return html + rerun_html(page) + "</html>\n";
}

}  // namespace opal::statistics
