#include "benchmark/experiments/kit/order_statistics.hpp"

#include <opal/common/quantile.hpp>

#include <fmt/format.h>
#include <boost/math/distributions/binomial.hpp>

#include <algorithm>
#include <cmath>

namespace opal::experiments {

double median(std::vector<double> values) { return median_of(std::move(values)).value_or(kNever); }

Interval median_interval(std::vector<double> values) {
  if (values.empty()) return {kNever, kNever};
  std::sort(values.begin(), values.end());
  // As many values may be left out on either side as are below the median with 2.5 % at most.
  const std::size_t n = values.size();
  const boost::math::binomial_distribution<> below(static_cast<double>(n), 0.5);
  std::size_t rank = 0;
  while (cdf(below, static_cast<double>(rank + 1)) <= 0.025) ++rank;
  return {values[rank], values[n - 1 - rank]};
}

std::string number(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

std::string share_text(int part, std::size_t whole) {
  if (whole == 0) return "none of 0";
  const double share = static_cast<double>(part) / static_cast<double>(whole);
  const Interval within = wilson_interval(share, static_cast<double>(whole));
  return fmt::format("{} of {}, {:.1f} % (95 %: {:.1f} to {:.1f})", part, whole, 100 * share, 100 * within.low,
                     100 * within.high);
}

}  // namespace opal::experiments
