#include "benchmark/verdict/paired_sample.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace opal::statistics {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

auto key(const ResultRow& row) { return std::tie(row.cluster, row.query, row.seed); }

std::string name_of(const ResultRow& row) {
  return fmt::format("{}, query {}, seed {}", row.cluster, row.query, row.seed);
}

using Rows = std::vector<const ResultRow*>;

Rows rows_of(const ResultsTable& table, const std::string& arm) {
  Rows rows;
  for (const ResultRow& row : table)
    if (row.arm == arm) rows.push_back(&row);
  std::sort(rows.begin(), rows.end(), [](const ResultRow* x, const ResultRow* y) { return key(*x) < key(*y); });
  const auto twice = std::adjacent_find(rows.begin(), rows.end(),
                                        [](const ResultRow* x, const ResultRow* y) { return key(*x) == key(*y); });
  if (twice != rows.end())
    throw Error("results of arm " + arm + ": " + name_of(**twice) + " is there twice, expected once");
  return rows;
}

void check_same_queries(const Rows& a, const Rows& b, const std::string& arm_a, const std::string& arm_b) {
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const bool only_a = i >= b.size() || (i < a.size() && key(*a[i]) < key(*b[i]));
    const bool only_b = i >= a.size() || (i < b.size() && key(*b[i]) < key(*a[i]));
    if (only_a)
      throw Error("results: " + name_of(*a[i]) + " is there for arm " + arm_a + " but not for arm " + arm_b +
                  ", expected for both");
    if (only_b)
      throw Error("results: " + name_of(*b[i]) + " is there for arm " + arm_b + " but not for arm " + arm_a +
                  ", expected for both");
  }
}

double worst(const Metric& metric) {
  if (metric.kind == Metric::Kind::proportion) return metric.higher_is_better ? 0 : 1;
  return metric.higher_is_better ? -kNever : kNever;
}

double checked_proportion(double value, const ResultRow& row, const Metric& metric) {
  if (value != 0 && value != 1)
    throw Error(
        fmt::format("results of arm {}: {}: {} is {:f}, expected 0 or 1", row.arm, name_of(row), metric.name, value));
  return value;
}

/// None if nothing can be said of this row.
std::optional<double> value_of(const ResultRow& row, const Metric& metric) {
  if (!row.failure.empty()) return metric.kind == Metric::Kind::cost ? std::nullopt : std::optional(worst(metric));
  const auto found = row.values.find(metric.name);
  const bool known = found != row.values.end() && !std::isnan(found->second);
  if (metric.kind == Metric::Kind::distance_until) return known ? found->second : kNever;
  if (!known) return std::nullopt;
  if (metric.kind == Metric::Kind::proportion) return checked_proportion(found->second, row, metric);
  return found->second > 0 && std::isfinite(found->second) ? std::optional(found->second) : std::nullopt;
}

}  // namespace

PairedSample pair_rows(const ResultsTable& table, const Metric& metric, const std::string& arm_a,
                       const std::string& arm_b) {
  const Rows a = rows_of(table, arm_a), b = rows_of(table, arm_b);
  check_same_queries(a, b, arm_a, arm_b);
  PairedSample sample;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto value_a = value_of(*a[i], metric), value_b = value_of(*b[i], metric);
    if (value_a && value_b)
      sample.pairs.push_back({a[i]->cluster, a[i]->query, a[i]->seed, *value_a, *value_b});
    else
      ++sample.left_out;
  }
  return sample;
}

std::vector<std::span<const PairedValue>> clusters_of(const PairedSample& sample) {
  std::vector<std::span<const PairedValue>> clusters;
  const auto& pairs = sample.pairs;
  for (auto first = pairs.begin(), end = first; first != pairs.end(); first = end) {
    end = std::find_if(first, pairs.end(), [&](const PairedValue& pair) { return pair.cluster != first->cluster; });
    clusters.emplace_back(&*first, static_cast<std::size_t>(end - first));
  }
  return clusters;
}

}  // namespace opal::statistics
