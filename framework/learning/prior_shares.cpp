#include "learning/prior_shares.hpp"

#include <cmath>

namespace opal {
namespace {

constexpr VerdictLikelihood kBefore{0.9, 0.05, 0.05};
constexpr double kAddedBefore = 0.1;  // the others are furniture for a day
constexpr double kBeforeCounts = 20;
constexpr int kSteps = 60;  // of expectation maximization; in this order, so that it gives the same digits

}  // namespace

VerdictLikelihood prior_shares(std::span<const VerdictLikelihood> objects) {
  VerdictLikelihood shares = kBefore;
  for (int step = 0; step < kSteps; ++step) {
    VerdictLikelihood counts{};
    for (const VerdictLikelihood& object : objects) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += shares[k] * object[k];
      for (std::size_t k = 0; k < 3; ++k) counts[k] += shares[k] * object[k] / sum;
    }
    for (std::size_t k = 0; k < 3; ++k)
      shares[k] = (kBeforeCounts * kBefore[k] + counts[k]) / (kBeforeCounts + static_cast<double>(objects.size()));
  }
  return shares;
}

double log_odds(double probability) { return std::log(probability / (1 - probability)); }

double probability_of(double log_odds) { return 1 / (1 + std::exp(-log_odds)); }

double prior_share_of_additions(std::span<const double> odds_nat) {
  double share = kAddedBefore;
  for (int step = 0; step < kSteps; ++step) {
    double count = 0;
    for (const double each : odds_nat) count += probability_of(log_odds(share) + each);
    share = (kBeforeCounts * kAddedBefore + count) / (kBeforeCounts + static_cast<double>(odds_nat.size()));
  }
  return share;
}

}  // namespace opal
