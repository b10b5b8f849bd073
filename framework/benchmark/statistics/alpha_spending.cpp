#include "benchmark/statistics/alpha_spending.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>
#include <boost/math/distributions/normal.hpp>

#include <cmath>

namespace opal::statistics {
namespace {

const boost::math::normal kNormal;

double spent(double level, double information) {
  const double z = quantile(complement(kNormal, level / 4));
  return 4 * cdf(complement(kNormal, z / std::sqrt(information)));
}

/// Score process, a Brownian motion, at one look: its density where the experiment was not ended before.
struct Density {
  static constexpr int kIntervals = 400;  // even
  double bound = 0;                       ///< lives on [-bound, bound]
  std::vector<double> values;

  double place(int i) const { return bound * (2.0 * i / kIntervals - 1); }
  /// Integral of the density times a function (Simpson).
  template <class Function>
  double integrate(const Function& function) const {
    double sum = 0;
    for (int i = 0; i <= kIntervals; ++i) {
      const double weight = i == 0 || i == kIntervals ? 1 : i % 2 == 1 ? 4 : 2;
      sum += weight * values[static_cast<std::size_t>(i)] * function(place(i));
    }
    return sum * 2 * bound / kIntervals / 3;
  }
};

/// Chance to be beyond a bound at the next look, so much information later.
double chance_beyond(const Density& before, double step, double bound) {
  return before.integrate([&](double place) {
    return cdf(complement(kNormal, (bound - place) / std::sqrt(step))) +
           cdf(kNormal, (-bound - place) / std::sqrt(step));
  });
}

/// Where the chance to be beyond is what may be spent.
double bound_for(const Density& before, double step, double spend, double information) {
  double low = 0, high = 40 * std::sqrt(information);
  for (int i = 0; i < 60; ++i)
    (chance_beyond(before, step, 0.5 * (low + high)) > spend ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

Density first_density(double information, double bound) {
  Density density{bound, {}};
  for (int i = 0; i <= Density::kIntervals; ++i)
    density.values.push_back(pdf(kNormal, density.place(i) / std::sqrt(information)) / std::sqrt(information));
  return density;
}

Density next_density(const Density& before, double step, double bound) {
  Density density{bound, {}};
  for (int i = 0; i <= Density::kIntervals; ++i)
    density.values.push_back(before.integrate([&, to = density.place(i)](double from) {
      return pdf(kNormal, (to - from) / std::sqrt(step)) / std::sqrt(step);
    }));
  return density;
}

void check(std::span<const double> information) {
  double before = 0;
  for (const double now : information) {
    if (!(now > before && now <= 1))
      throw Error(fmt::format(
          "looks at an experiment: information {:f} after {:f}, expected increasing shares in (0, 1]", now, before));
    before = now;
  }
}

}  // namespace

std::vector<double> look_levels(double level, std::span<const double> information) {
  check(information);
  std::vector<double> levels;
  Density density;
  for (std::size_t look = 0; look < information.size(); ++look) {
    const double now = information[look];
    if (look == 0) {
      levels.push_back(spent(level, now));
      density = first_density(now, quantile(complement(kNormal, std::max(levels[0], 1e-300) / 2)) * std::sqrt(now));
      continue;
    }
    const double step = now - information[look - 1];
    const double bound = bound_for(density, step, spent(level, now) - spent(level, information[look - 1]), now);
    levels.push_back(2 * cdf(complement(kNormal, bound / std::sqrt(now))));
    if (look + 1 < information.size()) density = next_density(density, step, bound);
  }
  return levels;
}

double look_level(double level, int look, int looks) {
  if (looks < 1 || look < 1 || look > looks)
    throw Error(fmt::format("look {} of {}, expected one of 1 to as many as there are", look, looks));
  std::vector<double> information;
  for (int i = 1; i <= look; ++i) information.push_back(static_cast<double>(i) / looks);
  return look_levels(level, information).back();
}

}  // namespace opal::statistics
