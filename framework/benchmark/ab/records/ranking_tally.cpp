#include "benchmark/ab/records/ranking_tally.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace opal::ab {
namespace {

constexpr double kMost_nat = 10;  // one absurd scan must not decide

double best_nat(std::span<const RankedHypothesis> hypotheses, bool right) {
  double best = -std::numeric_limits<double>::infinity();
  for (const RankedHypothesis& hypothesis : hypotheses)
    if (hypothesis.right == right) best = std::max(best, hypothesis.nat);
  return best;
}

/// Of those on top, the share that is right.
double share_on_top(std::span<const RankedHypothesis> hypotheses, double top_nat) {
  double all = 0, right = 0;
  for (const RankedHypothesis& hypothesis : hypotheses) {
    if (hypothesis.nat < top_nat) continue;
    ++all;
    right += hypothesis.right;
  }
  return right / all;
}

double probability_of_right(std::span<const RankedHypothesis> hypotheses, double top_nat) {
  double all = 0, right = 0;
  for (const RankedHypothesis& hypothesis : hypotheses) {
    const double weight = std::exp(hypothesis.nat - top_nat);
    all += weight;
    if (hypothesis.right) right += weight;
  }
  return right / all;
}

}  // namespace

void RankingTally::add(std::span<const RankedHypothesis> hypotheses) {
  const double right = best_nat(hypotheses, true), wrong = best_nat(hypotheses, false);
  if (std::isinf(right) || std::isinf(wrong)) return;
  const double top = std::max(right, wrong);
  ++contests_;
  top_ += share_on_top(hypotheses, top);
  margin_nat_ += std::clamp(right - wrong, -kMost_nat, kMost_nat);
  loss_nat_ += std::min(kMost_nat, -std::log(probability_of_right(hypotheses, top)));
}

std::map<std::string, double> RankingTally::values() const {
  if (contests_ == 0) return {};
  const double n = static_cast<double>(contests_);
  return {{"top_share", top_ / n},
          {"on_top", top_ / n > 0.5},
          {"margin_nat", margin_nat_ / n},
          {"odds", std::exp(margin_nat_ / n)},
          {"log_loss_nat", loss_nat_ / n},
          {"surprise", std::exp(loss_nat_ / n)},
          {"contests", n}};
}

}  // namespace opal::ab
