#include "benchmark/verdict/comparison.hpp"

#include "benchmark/statistics/alpha_spending.hpp"
#include "benchmark/statistics/holm.hpp"
#include "benchmark/verdict/conclusion.hpp"
#include "benchmark/verdict/metric_comparison.hpp"
#include "benchmark/verdict/verdict_sentence.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace opal::statistics {
namespace {

/// In order of first appearance.
std::vector<std::string> arms_of(const ResultsTable& table) {
  std::vector<std::string> arms;
  for (const ResultRow& row : table)
    if (std::find(arms.begin(), arms.end(), row.arm) == arms.end()) arms.push_back(row.arm);
  return arms;
}

std::vector<std::string> baselines_of(const ResultsTable& table, const ComparisonOptions& options) {
  std::vector<std::string> arms = arms_of(table);
  if (std::erase(arms, options.baseline) == 0)
    throw Error("comparison: no result of the baseline " + options.baseline + ", expected one per query");
  return arms;
}

std::size_t failures_of(const ResultsTable& table, const std::string& arm) {
  return static_cast<std::size_t>(std::count_if(
      table.begin(), table.end(), [&](const ResultRow& row) { return row.arm == arm && !row.failure.empty(); }));
}

std::size_t clusters_of_table(const ResultsTable& table) {
  std::set<std::string> clusters;
  for (const ResultRow& row : table) clusters.insert(row.cluster);
  return clusters.size();
}

Verdict new_verdict(const ResultsTable& table, const std::string& arm, const ComparisonOptions& options, double level) {
  Verdict verdict;
  verdict.arm = arm;
  verdict.baseline = options.baseline;
  verdict.queries = static_cast<std::size_t>(
      std::count_if(table.begin(), table.end(), [&](const ResultRow& row) { return row.arm == arm; }));
  verdict.clusters = clusters_of_table(table);
  verdict.failures = failures_of(table, arm);
  verdict.failures_baseline = failures_of(table, options.baseline);
  verdict.look = options.look;
  verdict.looks = options.looks;
  verdict.level = level;
  return verdict;
}

/// Of all metrics of all verdicts.
void correct(std::vector<Verdict>& verdicts) {
  std::vector<double> p;
  for (const Verdict& verdict : verdicts)
    for (const MetricResult& metric : verdict.metrics) p.push_back(metric.p);
  const std::vector<double> corrected = holm(p);
  auto next = corrected.begin();
  for (Verdict& verdict : verdicts)
    for (MetricResult& metric : verdict.metrics) metric.p_corrected = *next++;
}

void check(const ComparisonOptions& options) {
  if (!(options.level > 0 && options.level < 1))
    throw Error(fmt::format("comparison: level {:f}, expected a share between 0 and 1", options.level));
  if (options.metrics.empty()) throw Error("comparison: no metric, expected at least one");
}

}  // namespace

std::vector<Verdict> compare(const ResultsTable& table, const ComparisonOptions& options) {
  check(options);
  const double level = look_level(options.level, options.look, options.looks);
  std::vector<Verdict> verdicts;
  std::vector<PairedSample> samples;
  for (const std::string& arm : baselines_of(table, options)) {
    verdicts.push_back(new_verdict(table, arm, options, level));
    for (const Metric& metric : options.metrics) {
      samples.push_back(pair_rows(table, metric, options.baseline, arm));
      verdicts.back().metrics.push_back(compare_metric(samples.back(), metric, level, options));
    }
  }
  correct(verdicts);
  auto sample = samples.begin();
  for (Verdict& verdict : verdicts) {
    for (MetricResult& metric : verdict.metrics) conclude(metric, *sample++, level, samples.size());
    verdict.sentence = sentence_of(verdict);
    verdict.notes = notes_of(verdict);
  }
  return verdicts;
}

}  // namespace opal::statistics
