#include "benchmark/experiments/kit/summary_json.hpp"

#include "benchmark/experiments/kit/order_statistics.hpp"

#include <cmath>

namespace opal::experiments {

nlohmann::ordered_json number_or_null(double value) {
  if (std::isfinite(value)) return value;
  return nullptr;
}

nlohmann::ordered_json share_json(int part, std::size_t whole) {
  const double trials = static_cast<double>(whole);
  const Interval within = wilson_interval(part / trials, trials);
  return {{"runs", part}, {"within", {within.low, within.high}}};
}

nlohmann::ordered_json median_json(const std::vector<double>& values) {
  const Interval within = median_interval(values);
  return {{"median", number_or_null(median(values))},
          {"within", {number_or_null(within.low), number_or_null(within.high)}}};
}

}  // namespace opal::experiments
