#include "benchmark/verdict_page/report_tables.hpp"

#include "benchmark/verdict/pair_scores.hpp"
#include "benchmark/verdict/quantity_words.hpp"
#include "benchmark/verdict_page/verdict_plots.hpp"
#include "report/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace opal::statistics {
namespace {

int decimals_of_size(const Metric& metric) {
  return metric.kind == Metric::Kind::proportion ? 1 : metric.kind == Metric::Kind::cost ? 3 : 2;
}

std::string size_of(const MetricResult& result, double size) {
  return fixed_text(shown_size(result.metric, size), decimals_of_size(result.metric));
}

std::string interval_of(const MetricResult& result, const Interval& interval) {
  return size_of(result, interval.low) + " to " + size_of(result, interval.high);
}

std::string odds_of(const MetricResult& result) {
  if (result.metric.kind != Metric::Kind::proportion) return "";
  return within_text(result.odds_ratio, result.odds_ratio_interval.low, result.odds_ratio_interval.high, 2);
}

std::string size_head(const MetricResult& result) {
  const PlotAxis axis = size_axis(result.metric);
  return axis.unit.empty() ? axis.name : axis.name + ", " + axis.unit;
}

std::string more_of(const MetricResult& result) {
  return result.outcome == Outcome::open ? fixed_text(std::ceil(result.more_queries), 0) : "";
}

/// What each row of the table of numbers shows.
struct Number {
  const char* name;
  std::string (*cell)(const MetricResult&);
};

constexpr Number kNumbers[] = {
    {"size is a", size_head},
    {"size", [](const MetricResult& r) { return size_of(r, r.effect.size); }},
    {"interval", [](const MetricResult& r) { return interval_of(r, r.effect.interval); }},
    {"p", [](const MetricResult& r) { return p_text(r.p); }},
    {"p, corrected after Holm", [](const MetricResult& r) { return p_text(r.p_corrected); }},
    {"outcome", [](const MetricResult& r) { return word_of(r.outcome); }},
    {"more queries needed", more_of},
    {"pairs", [](const MetricResult& r) { return std::to_string(r.pairs); }},
    {"pairs better, worse", [](const MetricResult& r) { return fmt::format("{}, {}", r.better, r.worse); }},
    {"matched odds ratio", odds_of},
    {"design effect", [](const MetricResult& r) { return fixed_text(r.design_effect, 2); }},
    {"p, pairs independent", [](const MetricResult& r) { return p_text(r.p_pairs); }},
    {"p, sign flips of sites", [](const MetricResult& r) { return p_text(r.p_sign_flip); }},
    {"bootstrap interval", [](const MetricResult& r) { return interval_of(r, r.bootstrap); }}};

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

std::string value_of(const Metric& metric, double value) {
  if (metric.kind == Metric::Kind::proportion) return value > 0.5 ? "yes" : "no";
  return value_text(metric, value);
}

}  // namespace

bool differs(const MetricResult& result) { return result.better + result.worse > 0; }

Table summary_table(const Verdict& verdict) {
  std::vector<const MetricResult*> results;
  for (const MetricResult& result : verdict.metrics) results.push_back(&result);
  std::stable_partition(results.begin(), results.end(), [](const MetricResult* result) { return differs(*result); });
  Table table{{{"metric", "", false},
               {verdict.baseline},
               {verdict.arm},
               {"difference"},
               {coverage_text(verdict.level) + " interval"},
               {"outcome", "", false}},
              {}};
  for (const MetricResult* result : results)
    table.rows.push_back({name_in_words(result->metric), value_text(result->metric, result->effect.a),
                          value_text(result->metric, result->effect.b),
                          differs(*result) ? signed_size_text(*result) : "none",
                          differs(*result) ? signed_interval_text(*result) : "", word_of(result->outcome)});
  return table;
}

Table numbers_table(const Verdict& verdict) {
  Table table{{{"", "", false}}, {}};
  for (const MetricResult& result : verdict.metrics) table.columns.push_back({name_in_words(result.metric)});
  for (const Number& shown : kNumbers) {
    table.rows.push_back({shown.name});
    for (const MetricResult& result : verdict.metrics) table.rows.back().push_back(shown.cell(result));
  }
  return table;
}

Table counts_table(const MetricResult& result, const std::string& arm, const std::string& baseline) {
  const auto row = [](const std::string& name, std::size_t yes, std::size_t no) {
    return std::vector<Cell>{name, std::to_string(yes), std::to_string(no)};
  };
  return {{{"", "", false}, {baseline + " yes"}, {baseline + " no"}},
          {row(arm + " yes", result.counts.both, result.counts.only_b),
           row(arm + " no", result.counts.only_a, result.counts.neither)}};
}

Table differing_table(const PairedSample& sample, const Metric& metric, const std::string& arm,
                      const std::string& baseline, const LinkedRuns& links) {
  Table table{{{"site", "", false}, {"query", "", false}, {"seed"}, {baseline}, {arm}}, {}};
  for (const PairedValue& pair : most_differing(sample, metric.kind)) {
    const auto cell = [&](const std::string& name, double value) {
      return Cell(value_of(metric, value), links.of(name, pair.cluster, pair.query, pair.seed));
    };
    table.rows.push_back(
        {pair.cluster, pair.query, std::to_string(pair.seed), cell(baseline, pair.a), cell(arm, pair.b)});
  }
  return table;
}

Table failures_table(const ResultsTable& table, const LinkedRuns& links) {
  Table failures{
      {{"arm", "", false}, {"site", "", false}, {"query", "", false}, {"seed"}, {"what happened", "", false}}, {}};
  for (const ResultRow& run : table)
    if (!run.failure.empty())
      failures.rows.push_back({run.arm, run.cluster,
                               Cell(run.query, links.of(run.arm, run.cluster, run.query, run.seed)),
                               std::to_string(run.seed), run.failure});
  return failures;
}

Table versions_table(const std::vector<ReportPage::Version>& versions) {
  Table table{{{"part", "", false}, {"version", "", false}, {"hash of its file", "", false}}, {}};
  for (const ReportPage::Version& version : versions)
    table.rows.push_back({version.name, version.version, version.file_hash});
  return table;
}

}  // namespace opal::statistics
