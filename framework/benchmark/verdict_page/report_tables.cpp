#include "benchmark/verdict_page/report_tables.hpp"

#include "benchmark/verdict/pair_scores.hpp"
#include "benchmark/verdict/quantity_words.hpp"
#include "report/html_text.hpp"
#include "report/quantity_text.hpp"

#include <algorithm>
#include <cmath>

namespace opal::statistics {
namespace {

using Cells = std::vector<std::string>;  // HTML

std::string row(const Cells& cells, const std::string& tag = "td") {
  std::string html = "<tr>";
  for (const std::string& cell : cells) html += "<" + tag + ">" + cell + "</" + tag + ">";
  return html + "</tr>\n";
}

std::string table_of(const Cells& head, const std::vector<Cells>& rows) {
  std::string html = "<div class=\"wide\"><table><thead>" + row(head, "th") + "</thead><tbody>\n";
  for (const Cells& cells : rows) html += row(cells);
  return html + "</tbody></table></div>\n";
}

std::string number(std::size_t count) { return std::to_string(count); }

std::string word_of(Outcome outcome) {
  constexpr const char* kWords[] = {"better", "worse", "no difference of interest", "open"};
  return kWords[static_cast<int>(outcome)];
}

std::string size_cell(const MetricResult& result, double size) {
  if (std::isnan(size)) return "-";
  if (std::isinf(size)) return size < 0 ? "-∞" : "∞";
  if (result.metric.kind == Metric::Kind::proportion) return fixed_text(100 * size, 1);
  return fixed_text(size, result.metric.kind == Metric::Kind::cost ? 3 : 2);
}

std::string interval_cell(const MetricResult& result, const Interval& interval) {
  return size_cell(result, interval.low) + " to " + size_cell(result, interval.high);
}

std::string odds_cell(const MetricResult& result) {
  if (result.metric.kind != Metric::Kind::proportion) return "";
  const auto odds = [](double value) {
    return std::isnan(value) ? "-" : std::isinf(value) ? "∞" : fixed_text(value, 2);
  };
  return odds(result.odds_ratio) + " (" + odds(result.odds_ratio_interval.low) + " to " +
         odds(result.odds_ratio_interval.high) + ")";
}

std::string size_head(const MetricResult& result) {
  if (result.metric.kind == Metric::Kind::proportion) return "difference, points";
  return result.metric.kind == Metric::Kind::cost ? "ratio" : "median difference, " + result.metric.unit;
}

std::string more_cell(const MetricResult& result) {
  const bool told = result.outcome == Outcome::better || result.outcome == Outcome::worse;
  if (told || result.outcome == Outcome::equal) return "";
  return std::isfinite(result.more_queries) ? fixed_text(std::ceil(result.more_queries), 0) : "∞";
}

/// What each row of the table of numbers shows.
struct Number {
  const char* name;
  std::string (*cell)(const MetricResult&);
};

constexpr Number kNumbers[] = {
    {"size is a", [](const MetricResult& r) { return html_text(size_head(r)); }},
    {"size", [](const MetricResult& r) { return size_cell(r, r.effect.size); }},
    {"interval", [](const MetricResult& r) { return interval_cell(r, r.effect.interval); }},
    {"p", [](const MetricResult& r) { return p_text(r.p); }},
    {"p, corrected after Holm", [](const MetricResult& r) { return p_text(r.p_corrected); }},
    {"outcome", [](const MetricResult& r) { return word_of(r.outcome); }},
    {"more queries needed", [](const MetricResult& r) { return more_cell(r); }},
    {"pairs", [](const MetricResult& r) { return number(r.pairs); }},
    {"pairs better, worse", [](const MetricResult& r) { return number(r.better) + ", " + number(r.worse); }},
    {"matched odds ratio", [](const MetricResult& r) { return odds_cell(r); }},
    {"design effect", [](const MetricResult& r) { return fixed_text(r.design_effect, 2); }},
    {"p, pairs independent", [](const MetricResult& r) { return p_text(r.p_pairs); }},
    {"p, sign flips of sites", [](const MetricResult& r) { return p_text(r.p_sign_flip); }},
    {"bootstrap interval", [](const MetricResult& r) { return interval_cell(r, r.bootstrap); }}};

/// How far apart, for sorting: infinite differences first.
double apart(const PairedValue& pair, Metric::Kind kind) {
  return kind == Metric::Kind::cost ? std::abs(std::log(pair.b / pair.a)) : std::abs(difference(pair));
}

std::vector<PairedValue> most_differing(const PairedSample& sample, Metric::Kind kind) {
  std::vector<PairedValue> pairs = sample.pairs;
  std::erase_if(pairs, [](const PairedValue& pair) { return pair.a == pair.b; });
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&](const PairedValue& x, const PairedValue& y) { return apart(x, kind) > apart(y, kind); });
  return pairs;
}

/// Longer tables are cut, and say so.
constexpr std::size_t kShown = 200;

std::string rest_text(std::size_t rows, const std::string& what) {
  return rows > kShown ? "<p>" + number(rows - kShown) + " more " + what + ".</p>\n" : "";
}

std::string value_cell(const Metric& metric, double value) {
  if (metric.kind == Metric::Kind::proportion) return value > 0.5 ? "yes" : "no";
  return html_text(value_text(metric, value));
}

}  // namespace

std::string numbers_table(const Verdict& verdict) {
  Cells head{""};
  for (const MetricResult& result : verdict.metrics) head.push_back(html_text(name_in_words(result.metric)));
  std::vector<Cells> rows;
  for (const Number& shown : kNumbers) {
    rows.push_back({shown.name});
    for (const MetricResult& result : verdict.metrics) rows.back().push_back(shown.cell(result));
  }
  return table_of(head, rows);
}

std::string counts_table(const MetricResult& result, const std::string& arm, const std::string& baseline) {
  const std::string a = html_text(baseline), b = html_text(arm);
  return table_of({"", a + " yes", a + " no"},
                  {{b + " yes", number(result.counts.both), number(result.counts.only_b)},
                   {b + " no", number(result.counts.only_a), number(result.counts.neither)}});
}

std::string differing_table(const PairedSample& sample, const Metric& metric, const std::string& arm,
                            const std::string& baseline, const LinkedRuns& links) {
  const std::vector<PairedValue> pairs = most_differing(sample, metric.kind);
  if (pairs.empty()) return "<p>No pair differs.</p>\n";
  std::vector<Cells> rows;
  for (const PairedValue& pair : pairs) {
    if (rows.size() == kShown) break;
    const auto cell = [&](const std::string& name, double value) {
      return linked(links.of(name, pair.cluster, pair.query, pair.seed), value_cell(metric, value));
    };
    rows.push_back({html_text(pair.cluster), html_text(pair.query), std::to_string(pair.seed), cell(baseline, pair.a),
                    cell(arm, pair.b)});
  }
  return table_of({"site", "query", "seed", html_text(baseline), html_text(arm)}, rows) +
         rest_text(pairs.size(), "differ less");
}

std::string cost_table(const MetricResult& result, const std::string& arm, const std::string& baseline) {
  std::vector<Cells> rows;
  const auto add = [&](const std::string& name, std::size_t pairs, const Effect& effect) {
    rows.push_back({html_text(name), number(pairs), html_text(value_text(result.metric, effect.a)),
                    html_text(value_text(result.metric, effect.b)), size_cell(result, effect.size),
                    interval_cell(result, effect.interval)});
  };
  for (const ClusterResult& cluster : result.clusters) add(cluster.cluster, cluster.pairs, cluster.effect);
  add("all", result.pairs, result.effect);
  return table_of(
      {"site", "queries", html_text(baseline) + ", median", html_text(arm) + ", median", "ratio", "interval"}, rows);
}

std::string failures_table(const ResultsTable& table, const LinkedRuns& links) {
  std::vector<Cells> rows;
  std::size_t failures = 0;
  for (const ResultRow& result : table)
    if (!result.failure.empty() && ++failures <= kShown)
      rows.push_back({html_text(result.arm), html_text(result.cluster),
                      linked(links.of(result.arm, result.cluster, result.query, result.seed), html_text(result.query)),
                      std::to_string(result.seed), html_text(result.failure)});
  if (rows.empty()) return "<p>Every run came to its end.</p>\n";
  return table_of({"arm", "site", "query", "seed", "what happened"}, rows) + rest_text(failures, "failed");
}

std::string versions_table(const std::vector<ReportPage::Version>& versions) {
  std::vector<Cells> rows;
  for (const ReportPage::Version& version : versions)
    rows.push_back(
        {html_text(version.name), html_text(version.version), "<code>" + html_text(version.file_hash) + "</code>"});
  return table_of({"part", "version", "hash of its file"}, rows);
}

}  // namespace opal::statistics
