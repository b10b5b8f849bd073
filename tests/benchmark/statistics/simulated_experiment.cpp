#include "simulated_experiment.hpp"

#include "common/random.hpp"

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace opal::statistics;

namespace {

/// An arm's chance: what it has in common with all windows of a site, and its own.
class Noise {
 public:
  Noise(double correlated, opal::Random& random)
      : own_(std::sqrt(1 - correlated)), of_site_(random.normal(std::sqrt(correlated))) {}
  double draw(opal::Random& random) const { return of_site_ + random.normal(own_); }

 private:
  double own_, of_site_;
};

std::map<std::string, double> values(double ease, double cost) {
  const bool success = ease > 0;
  return {{"success", success ? 1 : 0},
          {"distance_m", success ? std::max(0.0, 3 - 2 * ease) : std::numeric_limits<double>::infinity()},
          {"cpu_ms", cost}};
}

}  // namespace

ResultsTable simulate(const SimulatedExperiment& e, std::uint64_t seed) {
  opal::Random random(seed);
  const double mean = quantile(boost::math::normal(), e.success) * std::sqrt(1 + e.site_sigma * e.site_sigma);
  ResultsTable table;
  for (std::size_t site = 0; site < e.cluster_sizes.size(); ++site) {
    const double easy = mean + random.normal(e.site_sigma);
    const std::array<Noise, 2> ease{Noise(e.correlated, random), Noise(e.correlated, random)};
    const std::array<Noise, 2> cost{Noise(e.correlated, random), Noise(e.correlated, random)};
    for (std::size_t query = 0; query < e.cluster_sizes[site]; ++query) {
      const double shared = easy + random.normal(std::sqrt(e.common)), shared_cost = random.normal(0.4);
      for (const std::size_t arm : {0u, 1u}) {
        const double z = shared + std::sqrt(1 - e.common) * ease[arm].draw(random) + (arm == 1 ? e.planted : 0);
        const double ms = (arm == 1 ? e.cost_ratio : 1) * std::exp(shared_cost + 0.1 * cost[arm].draw(random));
        table.push_back(
            {arm == 0 ? "a" : "b", "site" + std::to_string(site), "q" + std::to_string(query), 1, values(z, ms), ""});
      }
    }
  }
  return table;
}

ComparisonOptions simulated_comparison() {
  using Kind = Metric::Kind;
  ComparisonOptions options;
  options.baseline = "a";
  options.metrics = {{"success", Kind::proportion, true, "", "localizes in", 0},
                     {"distance_m", Kind::distance_until, false, "m", "", 0},
                     {"cpu_ms", Kind::cost, false, "ms", "CPU", 0}};
  options.bootstrap_samples = 0;
  return options;
}
