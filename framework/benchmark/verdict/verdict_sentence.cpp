#include "benchmark/verdict/verdict_sentence.hpp"

#include "benchmark/verdict/quantity_words.hpp"
#include "common/phrases.hpp"
#include "report/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace opal::statistics {
namespace {

using Kind = Metric::Kind;

bool told(const MetricResult& result) { return result.outcome == Outcome::better || result.outcome == Outcome::worse; }

std::string both_values(const MetricResult& result) {
  return value_text(result.metric, result.effect.b) + " against " + value_text(result.metric, result.effect.a);
}

std::string in_brackets(const std::string& text) { return " (" + text + ")"; }

std::string proportion_clause(const MetricResult& result, double level) {
  return phrase_of(result.metric) + " " + both_values(result) +
         in_brackets(size_text(result) + ", " + interval_text(result, level));
}

/// Whether the median says what the ranks say: with many ties it is 0 though one arm is ahead wherever they differ.
bool median_tells(const MetricResult& result) {
  const double size = result.effect.size;
  const bool better = (size > 0) == result.metric.higher_is_better;
  return std::isfinite(size) && fixed_text(size, 1) != fixed_text(0, 1) &&
         better == (result.outcome == Outcome::better);
}

std::string distance_clause(const MetricResult& result, double level) {
  const std::string prefix = result.metric.phrase.empty() ? "" : result.metric.phrase + " ";
  if (median_tells(result)) return prefix + size_text(result) + in_brackets(interval_text(result, level));
  const std::size_t sooner = result.metric.higher_is_better ? result.worse : result.better;
  const std::size_t later = result.metric.higher_is_better ? result.better : result.worse;
  return fmt::format("{}sooner in {} and later in {} of {}", prefix, sooner, later, count_of(result.pairs, "pair"));
}

std::string cost_clause(const MetricResult& result, double level) {
  return size_text(result) + " " + phrase_of(result.metric) + in_brackets(interval_text(result, level));
}

std::string told_clause(const MetricResult& result, double level) {
  if (result.metric.kind == Kind::proportion) return proportion_clause(result, level);
  return result.metric.kind == Kind::cost ? cost_clause(result, level) : distance_clause(result, level);
}

/// Of the first clause, which may have no verb.
std::string subject(const Verdict& verdict, const MetricResult& first) {
  if (first.metric.kind == Kind::cost) return verdict.arm + ": ";
  return verdict.arm + (first.metric.kind == Kind::distance_until && first.metric.phrase.empty() ? " is " : " ");
}

std::vector<std::string> clusters_with(const MetricResult& result, Outcome outcome) {
  std::vector<std::string> names;
  for (const ClusterResult& cluster : result.clusters)
    if (cluster.outcome == outcome) names.push_back(cluster.cluster);
  return names;
}

/// "better on a and b, worse on c, no difference told elsewhere"
std::string clusters_clause(const MetricResult& result) {
  const auto better = clusters_with(result, Outcome::better), worse = clusters_with(result, Outcome::worse);
  if (result.clusters.size() < 2) return "";
  if (better.empty() && worse.empty()) return "no difference told on any site by itself";
  std::string text;
  if (!better.empty()) text += "better on " + list_text(better);
  if (!worse.empty()) text += std::string(text.empty() ? "" : ", ") + "worse on " + list_text(worse);
  return better.size() + worse.size() < result.clusters.size() ? text + ", no difference told elsewhere" : text;
}

std::string told_sentence(const Verdict& verdict) {
  std::string text;
  for (const MetricResult& result : verdict.metrics)
    if (told(result)) text += (text.empty() ? subject(verdict, result) : ", ") + told_clause(result, verdict.level);
  if (text.empty()) return "";
  const MetricResult& first = verdict.metrics.front();
  const std::string clusters = told(first) ? clusters_clause(first) : "";
  return text + (clusters.empty() ? "" : "; " + clusters) + ".";
}

/// What is in the interval, rounded up so that rounding does not deny it.
double largest(const MetricResult& result) {
  const Interval& size = result.effect.interval;
  const bool cost = result.metric.kind == Kind::cost;
  const double exact = cost ? std::max(size.high, 1 / size.low) - 1 : std::max(std::abs(size.low), std::abs(size.high));
  const double steps = result.metric.kind == Kind::distance_until ? 10 : 1000;
  return std::ceil(exact * steps - 1e-9) / steps;
}

std::string equal_sentence(const MetricResult& result, double level) {
  return "No difference in " + name_in_words(result.metric) + " bigger than " +
         distance_text(result.metric, largest(result)) + " is to be expected" +
         in_brackets(both_values(result) + ", " + interval_text(result, level)) + ".";
}

/// Ranks have no metres: of a distance it is the difference seen.
std::string difference_to_tell(const MetricResult& result) {
  if (result.metric.kind == Kind::distance_until) return "such a difference";
  return "a difference of " + distance_text(result.metric, result.told);
}

bool excludes_no_difference(const MetricResult& result) {
  const double none = result.metric.kind == Kind::cost ? 1 : 0;
  return result.effect.interval.low > none || result.effect.interval.high < none;
}

/// Why there is no verdict though the interval excludes "no difference"; empty if it does not.
std::string reason_of_doubt(const MetricResult& result, double level) {
  if (!excludes_no_difference(result)) return "";
  if (result.p > level)
    return fmt::format("the interval is of the size alone; the test decides, and says p = {}; ", p_text(result.p));
  return fmt::format("alone it would be one (p = {}), but corrected for all comparisons of this experiment p is {}; ",
                     p_text(result.p), p_text(result.p_corrected));
}

std::string open_sentence(const MetricResult& result, double level) {
  if (result.pairs == 0) return "No verdict on " + name_in_words(result.metric) + ": no query has a value of both.";
  const std::string size =
      result.metric.kind == Kind::cost ? size_text(result) + " " + phrase_of(result.metric) : size_text(result);
  const std::string known = "No verdict yet on " + name_in_words(result.metric) +
                            in_brackets(both_values(result) + ", " + size + ", " + interval_text(result, level)) +
                            ": " + reason_of_doubt(result, level);
  if (std::isinf(result.more_queries))
    return known + "no number of queries that can be run would tell so small a difference.";
  return known + more_queries_text(result) + " would tell " + difference_to_tell(result) + ".";
}

std::string only_queries_of(std::size_t sites) {
  return std::string(" only, with ") + (sites == 1 ? "its" : "their") + " queries taken as independent.";
}

std::string scope_sentence(const Verdict& verdict) {
  if (verdict.clusters >= kFewestClusters) return "";
  return "Said of " + std::string(verdict.clusters == 1 ? "this site" : "these " + count_of(verdict.clusters, "site")) +
         only_queries_of(verdict.clusters);
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences)
    if (!sentence.empty()) text += (text.empty() ? "" : " ") + sentence;
  return text;
}

std::string failures_note(const std::string& arm, std::size_t failures, std::size_t queries) {
  if (failures == 0) return "";
  return fmt::format(
      "{} did not run to the end in {} of {} runs; that counts as worse than any result, and its costs are left out.",
      arm, failures, queries);
}

std::string never_note(const Verdict& verdict, const MetricResult& result) {
  if (result.metric.kind != Kind::distance_until || result.never_a + result.never_b == 0) return "";
  return fmt::format(
      "{} was never reached by {} in {} and by {} in {} of {} queries; that ranks behind every distance.",
      name_in_words(result.metric), verdict.arm, result.never_b, verdict.baseline, result.never_a, result.pairs);
}

std::string left_out_note(const Verdict& verdict, const MetricResult& result) {
  if (result.left_out == 0) return "";
  const std::string note = fmt::format("{} queries have no {} of both arms and are left out of it.", result.left_out,
                                       name_in_words(result.metric));
  if (result.between_clusters || verdict.clusters < kFewestClusters) return note;
  return note + " It is said of " + count_of(result.clusters.size(), "site") + only_queries_of(result.clusters.size());
}

std::string disagreement_note(const MetricResult& result, double level) {
  if (!result.between_clusters || told(result) || result.p_pairs > level) return "";
  if (result.p <= level && excludes_no_difference(result)) return "";  // the sentence says it
  if (result.p <= level)
    return fmt::format(
        "Alone, a difference in {} would be told (p = {}), but it does not hold after the correction for all "
        "comparisons of this experiment (p = {}).",
        name_in_words(result.metric), p_text(result.p), p_text(result.p_corrected));
  return "Query by query, a difference in " + name_in_words(result.metric) +
         " would be told (p = " + p_text(result.p_pairs) +
         "), but it does not hold from site to site (p = " + p_text(result.p) + ").";
}

std::string looks_note(const Verdict& verdict) {
  if (verdict.looks == 1) return "";
  return fmt::format(
      "This is look {} of {}: a corrected p-value must be below {} here, and intervals are as wide as that.",
      verdict.look, verdict.looks, p_text(verdict.level));
}

}  // namespace

std::string sentence_of(const Verdict& verdict) {
  std::vector<std::string> sentences{told_sentence(verdict)};
  for (const MetricResult& result : verdict.metrics)
    if (result.outcome == Outcome::equal) sentences.push_back(equal_sentence(result, verdict.level));
  for (const MetricResult& result : verdict.metrics)
    if (result.outcome == Outcome::open) sentences.push_back(open_sentence(result, verdict.level));
  sentences.push_back(scope_sentence(verdict));
  return joined(sentences);
}

std::vector<std::string> notes_of(const Verdict& verdict) {
  std::vector<std::string> notes{looks_note(verdict), failures_note(verdict.arm, verdict.failures, verdict.queries),
                                 failures_note(verdict.baseline, verdict.failures_baseline, verdict.queries)};
  for (const MetricResult& result : verdict.metrics) {
    notes.push_back(disagreement_note(result, verdict.level));
    notes.push_back(never_note(verdict, result));
    notes.push_back(left_out_note(verdict, result));
  }
  if (verdict.clusters > 1)
    notes.push_back(
        "What is said of a single site takes its queries as independent; where its windows overlap, its interval is "
        "too narrow.");
  std::erase(notes, "");
  return notes;
}

}  // namespace opal::statistics
