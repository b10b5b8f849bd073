#include "benchmark/statistics/power.hpp"

#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <cmath>
#include <limits>

namespace opal::statistics {
namespace {

constexpr double kMostUnits = 1e6;

double normal_power(double shift, double level) {
  const boost::math::normal normal;
  const double z = quantile(complement(normal, level / 2));
  return cdf(normal, shift - z) + cdf(normal, -shift - z);
}

}  // namespace

double t_test_power(double mean_in_sigmas, double units, double level) {
  constexpr double kLikeNormal = 2000;  // units; t and normal differ by less than 1e-3 in power there
  constexpr double kCertain = 30;       // standard errors
  if (units < 2) return 0;
  const double shift = std::abs(mean_in_sigmas) * std::sqrt(units);
  if (units > kLikeNormal || shift > kCertain) return normal_power(shift, level);
  const double bound = quantile(complement(boost::math::students_t(units - 1), level / 2));
  if (shift == 0) return level;
  const boost::math::non_central_t shifted(units - 1, shift);
  return cdf(complement(shifted, bound)) + cdf(shifted, -bound);
}

double units_for_power(double mean_in_sigmas, double level, double power) {
  double low = 1, high = 2;
  while (t_test_power(mean_in_sigmas, high, level) < power) {
    low = high;
    high *= 2;
    if (high > kMostUnits) return std::numeric_limits<double>::infinity();
  }
  while (high - low > 1) {
    const double middle = std::floor(0.5 * (low + high));
    (t_test_power(mean_in_sigmas, middle, level) < power ? low : high) = middle;
  }
  return high;
}

double design_effect(double variance_clustered, double variance_independent) {
  return variance_independent > 0 ? variance_clustered / variance_independent : 1;
}

}  // namespace opal::statistics
