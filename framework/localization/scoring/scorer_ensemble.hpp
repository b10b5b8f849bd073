#pragma once

#include "localization/observation/plugin_failures.hpp"

#include <opal/localization/scoring/active_scorer.hpp>
#include <opal/map/view/map_view.hpp>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace opal {

/// Asks the scorers. A scorer that throws contributes nothing to the hypotheses that it was asked about, and is
/// counted.
class OPAL_EXPORT ScorerEnsemble {
 public:
  /// @param failures  counts what scorers throw; must outlive this.
  ScorerEnsemble(std::vector<ActiveScorer> scorers, std::shared_ptr<const MapView> map, PluginFailures& failures);

  bool judges_associations() const { return judges_associations_; }  ///< any of the scorers

  /// Sum of the deciding scorers' contributions [nat].
  double decide(const Hypothesis& hypothesis, const Observation& observation) const;

  struct Verdict {
    double nat = 0;             ///< sum over deciding scorers
    std::string veto;           ///< first veto of a deciding scorer, with its name; empty: none
    std::vector<Score> scores;  ///< all scorers, in the order of `scorers()`
  };
  /// A hypothesis without memories is one that has met nothing yet.
  Verdict judge(const Hypothesis& hypothesis, const Observation& observation) const;

  using Hypotheses = std::span<const Hypothesis* const>;
  /// `decide` of each, in one call of each scorer.
  std::vector<double> decide_all(Hypotheses hypotheses, const Observation& observation) const;
  /// `judge` of each, likewise.
  std::vector<Verdict> judge_all(Hypotheses hypotheses, const Observation& observation) const;

  /// Adds what the scorers have seen to what they remember of the hypothesis.
  /// @param weight  share of a whole, independent piece of evidence that the scan is, in (0, 1].
  void remember(Hypothesis& hypothesis, const std::vector<Score>& scores, double weight) const;
  /// Lets what the scorers remember of the hypothesis fade, as one more scan is tracked.
  void fade(Hypothesis& hypothesis, double weight) const;

  /// What all scorers can say about a hypothesis in words, with their names: the first three findings of each.
  struct NamedFinding {
    std::string scorer;
    Finding finding;
  };
  std::vector<NamedFinding> explain(const Hypothesis& hypothesis, const Observation& observation) const;

  const std::vector<ActiveScorer>& scorers() const { return scorers_; }

 private:
  /// One score for each hypothesis, whatever the scorer does.
  std::vector<Score> ask(std::size_t scorer, Hypotheses hypotheses, const Observation& observation) const;
  const ScorerMemories& memories_of(const Hypothesis& hypothesis) const {
    return hypothesis.memories.empty() ? new_memories_ : hypothesis.memories;
  }
  /// A score that is no number counts as a failure, and says nothing.
  void expect_finite(Score& score, const std::string& name) const;
  void add(Verdict& verdict, std::size_t scorer, Score score) const;

  std::vector<ActiveScorer> scorers_;
  std::shared_ptr<const MapView> map_;
  PluginFailures& failures_;
  bool judges_associations_ = false;
  std::vector<bool> usable_;     ///< by scorer: it made the memory that it wants, or wants none
  ScorerMemories new_memories_;  ///< of a hypothesis that has met nothing yet
};

}  // namespace opal
