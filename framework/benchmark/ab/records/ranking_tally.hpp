#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>

namespace opal::ab {

/// One hypothesis, as one scorer judges it.
struct RankedHypothesis {
  double nat = 0;      ///< of the newest scan
  bool right = false;  ///< in truth
};

/// How well a scorer ranks hypotheses, scan by scan. A scan counts if there was something to tell apart: a right
/// hypothesis and a wrong one.
class RankingTally {
 public:
  void add(std::span<const RankedHypothesis> hypotheses);

  /// Over the scans that counted; empty if none did. `top_share`: how often a right hypothesis is on top, ties by their
  /// share; `on_top`: 1 if that is more than half; `margin_nat`: mean of the best right score less the best wrong one,
  /// each limited to +-10; `odds`: its exponential; `log_loss_nat`: mean of -ln of the share of the right ones in
  /// exp(score), each limited to 10; `surprise`: its exponential (perplexity); `contests`: the number of scans.
  std::map<std::string, double> values() const;

 private:
  std::size_t contests_ = 0;
  double top_ = 0, margin_nat_ = 0, loss_nat_ = 0;  ///< sums
};

}  // namespace opal::ab
