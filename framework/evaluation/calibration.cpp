#include "evaluation/calibration.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

namespace opal {
namespace {

constexpr std::array kEnds{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99, 0.999, 1.0};
constexpr double kNearlyCertain = 1e-9;

std::size_t bin_of(double probability) {
  const auto end = std::upper_bound(kEnds.begin(), kEnds.end(), probability);
  return std::min<std::size_t>(end - kEnds.begin(), kEnds.size() - 1);
}

/// Weighted sums over the statements of one bin: every measure follows from them.
struct Sums {
  double weight = 0, said = 0, came_true = 0, squared_error = 0, log_loss = 0;

  void add(const Sums& other, double times) {
    weight += times * other.weight;
    said += times * other.said;
    came_true += times * other.came_true;
    squared_error += times * other.squared_error;
    log_loss += times * other.log_loss;
  }
};
using Binned = std::array<Sums, kEnds.size()>;

Sums sums_of(const Statement& statement) {
  const double p = std::clamp(statement.probability, kNearlyCertain, 1 - kNearlyCertain);
  const double error = statement.probability - (statement.came_true ? 1 : 0);
  return {1, statement.probability, statement.came_true ? 1.0 : 0.0, error * error,
          -std::log(statement.came_true ? p : 1 - p)};
}

struct Cluster {
  Binned binned{};
  std::array<std::size_t, kEnds.size()> statements{};
};

std::vector<Cluster> clusters_of(std::span<const Statement> statements, Weighting weighting) {
  std::map<std::string, std::size_t> sizes;
  for (const Statement& statement : statements) {
    if (!(statement.probability >= 0 && statement.probability <= 1))
      throw ConfigError(
          fmt::format("calibration: {}: probability {:f}, expected 0 to 1", statement.cluster, statement.probability));
    ++sizes[statement.cluster];
  }
  std::map<std::string, Cluster> clusters;
  for (const Statement& statement : statements) {
    const double weight = weighting == Weighting::per_cluster ? 1 / static_cast<double>(sizes[statement.cluster]) : 1;
    Cluster& cluster = clusters[statement.cluster];
    const std::size_t bin = bin_of(statement.probability);
    cluster.binned[bin].add(sums_of(statement), weight);
    ++cluster.statements[bin];
  }
  std::vector<Cluster> all;
  for (auto& [name, cluster] : clusters) all.push_back(cluster);
  return all;
}

/// The measures that are one number each.
void measure(const Binned& binned, Calibration& result) {
  Sums total;
  for (const Sums& bin : binned) total.add(bin, 1);
  result.came_true = total.came_true / total.weight;
  result.brier = total.squared_error / total.weight;
  result.log_loss = total.log_loss / total.weight;
  result.uncertainty = result.came_true * (1 - result.came_true);
  result.reliability = result.resolution = result.expected_error = 0;
  for (const Sums& bin : binned) {
    if (bin.weight == 0) continue;
    const double share = bin.weight / total.weight, said = bin.said / bin.weight, was = bin.came_true / bin.weight;
    result.reliability += share * (said - was) * (said - was);
    result.resolution += share * (was - result.came_true) * (was - result.came_true);
    result.expected_error += share * std::abs(said - was);
  }
  result.within_bins = result.brier - (result.reliability - result.resolution + result.uncertainty);
}

Interval middle_95(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(std::lround(share * double(values.size() - 1)))];
  };
  return {at(0.025), at(0.975)};
}

void bootstrap(const std::vector<Cluster>& clusters, int resamples, std::uint64_t seed, Calibration& result) {
  if (resamples < 1) return;
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<std::size_t> pick(0, clusters.size() - 1);
  std::vector<double> brier, log_loss, expected_error;
  for (int n = 0; n < resamples; ++n) {
    Binned drawn{};
    for (std::size_t k = 0; k < clusters.size(); ++k) {
      const Cluster& cluster = clusters[pick(random)];
      for (std::size_t bin = 0; bin < drawn.size(); ++bin) drawn[bin].add(cluster.binned[bin], 1);
    }
    Calibration one;
    measure(drawn, one);
    brier.push_back(one.brier);
    log_loss.push_back(one.log_loss);
    expected_error.push_back(one.expected_error);
  }
  result.brier_within = middle_95(std::move(brier));
  result.log_loss_within = middle_95(std::move(log_loss));
  result.expected_error_within = middle_95(std::move(expected_error));
}

ReliabilityBin reliability_bin(std::size_t number, const Sums& sums, const std::vector<Cluster>& clusters) {
  ReliabilityBin bin{number == 0 ? 0.0 : kEnds[number - 1],
                     kEnds[number],
                     0,
                     0,
                     sums.said / sums.weight,
                     sums.came_true / sums.weight,
                     {}};
  for (const Cluster& cluster : clusters) {
    bin.statements += cluster.statements[number];
    bin.clusters += cluster.statements[number] > 0;
  }
  bin.came_true_within = wilson_interval(bin.came_true, static_cast<double>(bin.clusters));
  return bin;
}

}  // namespace

Interval wilson_interval(double share, double trials) {
  constexpr double kZ = 1.959964;  // 95 %
  const double z2 = kZ * kZ / trials, centre = (share + z2 / 2) / (1 + z2);
  const double half = kZ / (1 + z2) * std::sqrt(share * (1 - share) / trials + z2 / (4 * trials));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

Calibration calibration_of(std::span<const Statement> statements, Weighting weighting, int resamples,
                           std::uint64_t seed) {
  if (statements.empty()) throw ConfigError("calibration: no statement with a probability, expected at least one");
  const std::vector<Cluster> clusters = clusters_of(statements, weighting);
  Calibration result;
  result.statements = statements.size();
  result.clusters = clusters.size();
  Binned all{};
  for (const Cluster& cluster : clusters)
    for (std::size_t bin = 0; bin < all.size(); ++bin) all[bin].add(cluster.binned[bin], 1);
  measure(all, result);
  for (std::size_t bin = 0; bin < all.size(); ++bin)
    if (all[bin].weight > 0) result.bins.push_back(reliability_bin(bin, all[bin], clusters));
  bootstrap(clusters, resamples, seed, result);
  return result;
}

}  // namespace opal
