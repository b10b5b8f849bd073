#include "benchmark/verdict/quantity_words.hpp"

#include "report/quantity_text.hpp"

#include <algorithm>
#include <cmath>

namespace opal::statistics {
namespace {

using Kind = Metric::Kind;

/// From there on a cost is so many times the other instead of so many percent more.
constexpr double kTimes = 2;

std::string with_unit(double value, int decimals, const std::string& unit) {
  return fixed_text(value, decimals) + (unit.empty() ? "" : " " + unit);
}

std::string end_text(double value, int decimals) {
  return std::isinf(value) ? "beyond all bounds" : fixed_text(value, decimals);
}

std::string ends_text(double low, double high, int decimals) {
  if (std::isinf(low) && std::isinf(high)) return "without bounds";
  return end_text(low, decimals) + " to " + end_text(high, decimals);
}

bool is_less(const MetricResult& result) { return result.effect.size < (result.metric.kind == Kind::cost ? 1 : 0); }

/// Of percent: small ones need more.
int decimals_of(double percent) { return std::abs(percent) < 10 ? 1 : 0; }

std::string percent_ends(double low, double high) {
  return ends_text(100 * low, 100 * high, decimals_of(100 * std::max(std::abs(low), std::abs(high))));
}

std::string cost_ends(const MetricResult& result) {
  const Interval& ratio = result.effect.interval;
  if (result.effect.size >= kTimes) return ends_text(ratio.low, ratio.high, 1);
  return is_less(result) ? percent_ends(1 - ratio.high, 1 - ratio.low) : percent_ends(ratio.low - 1, ratio.high - 1);
}

std::string distance_ends(const MetricResult& result) {
  const Interval& size = result.effect.interval;
  return is_less(result) ? ends_text(-size.high, -size.low, 1) : ends_text(size.low, size.high, 1);
}

double two_digits(double value) {
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(value)) - 1));
  return unit * std::round(value / unit);
}

}  // namespace

std::string word_of(Outcome outcome) {
  constexpr const char* kWords[] = {"better", "worse", "no difference of interest", "open"};
  return kWords[static_cast<int>(outcome)];
}

std::string name_in_words(const Metric& metric) {
  std::string name = metric.name;
  if (metric.kind == Kind::cost && !metric.phrase.empty()) return metric.phrase;
  if (!metric.unit.empty() && name.ends_with("_" + metric.unit)) name.resize(name.size() - metric.unit.size() - 1);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string phrase_of(const Metric& metric) {
  if (!metric.phrase.empty()) return metric.phrase;
  return metric.kind == Kind::proportion ? "has " + name_in_words(metric) + " in" : name_in_words(metric);
}

std::string value_text(const Metric& metric, double value) {
  if (std::isnan(value)) return "nothing";
  if (metric.kind == Kind::proportion) return fixed_text(100 * value, 1) + " %";
  return std::isinf(value) ? "never" : with_unit(value, 2, metric.unit);
}

std::string distance_text(const Metric& metric, double size) {
  if (metric.kind == Kind::proportion) return fixed_text(100 * std::abs(size), 1) + " points";
  if (metric.kind == Kind::distance_until) return with_unit(std::abs(size), 1, metric.unit);
  return fixed_text(100 * std::abs(size), decimals_of(100 * size)) + " %";
}

std::string coverage_text(double level) {
  const double percent = 100 * (1 - level);
  return fixed_text(percent, std::abs(percent - std::round(percent)) < 1e-9 ? 0 : 2) + " %";
}

std::string interval_text(const MetricResult& result, double level) {
  const Interval& size = result.effect.interval;
  const std::string ends = result.metric.kind == Kind::proportion ? ends_text(100 * size.low, 100 * size.high, 1)
                           : result.metric.kind == Kind::cost     ? cost_ends(result)
                                                                  : distance_ends(result);
  return coverage_text(level) + " interval " + ends;
}

std::string size_text(const MetricResult& result) {
  const double size = result.effect.size;
  if (std::isnan(size)) return "nothing to compare";
  if (result.metric.kind == Kind::proportion) return "difference " + fixed_text(100 * size, 1) + " points";
  if (result.metric.kind == Kind::cost)
    return size >= kTimes ? fixed_text(size, 1) + " times the"
                          : distance_text(result.metric, size - 1) + (size < 1 ? " less" : " more");
  if (std::isinf(size))
    return size < 0 ? "mostly where the other never arrives" : "mostly never where the other arrives";
  if (fixed_text(size, 1) == fixed_text(0, 1)) return "median difference " + distance_text(result.metric, 0);
  return "median " + distance_text(result.metric, size) + (size < 0 ? " sooner" : " later");
}

std::string signed_size_text(const MetricResult& result) {
  const double size = result.effect.size;
  if (!std::isfinite(size)) return size_text(result);
  if (result.metric.kind == Kind::proportion) return with_unit(100 * size, 1, "points");
  if (result.metric.kind == Kind::distance_until) return with_unit(size, 2, result.metric.unit);
  return size >= kTimes ? with_unit(size, 1, "times") : with_unit(100 * (size - 1), decimals_of(100 * (size - 1)), "%");
}

std::string signed_interval_text(const MetricResult& result) {
  const Interval& size = result.effect.interval;
  if (result.metric.kind == Kind::proportion) return ends_text(100 * size.low, 100 * size.high, 1);
  if (result.metric.kind == Kind::distance_until) return ends_text(size.low, size.high, 2);
  return result.effect.size >= kTimes ? ends_text(size.low, size.high, 1) : percent_ends(size.low - 1, size.high - 1);
}

std::string more_queries_text(const MetricResult& result) {
  const double more = two_digits(std::ceil(result.more_queries));
  const std::string queries = "about " + fixed_text(more, 0) + (more == 1 ? " more query" : " more queries");
  if (!result.between_clusters) return queries;
  const double per_cluster = static_cast<double>(result.pairs) / static_cast<double>(result.clusters.size());
  const double sites = two_digits(std::ceil(result.more_queries / per_cluster - 1e-9));
  return queries + ", from " + fixed_text(sites, 0) + (sites == 1 ? " more site" : " more sites") + " like these,";
}

std::string list_text(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

}  // namespace opal::statistics
