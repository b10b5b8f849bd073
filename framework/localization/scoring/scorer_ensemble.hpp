#pragma once

#include <opal/localization/scoring/active_scorer.hpp>
#include <opal/map/view/map_view.hpp>

#include <map>
#include <string>
#include <vector>

namespace opal {

/// Asks the scorers. A scorer that throws contributes nothing to that scan and is counted.
class ScorerEnsemble {
 public:
  ScorerEnsemble(std::vector<ActiveScorer> scorers, std::shared_ptr<const MapView> map,
        std::map<std::string, int>& failures)
      : scorers_(std::move(scorers)), map_(std::move(map)), failures_(failures) {}

  bool judges_associations() const;  ///< any of the scorers

  /// Sum of the deciding scorers' contributions [nat].
  double decide(const Hypothesis& hypothesis, const Observation& observation) const;

  struct Verdict {
    double nat = 0;             ///< sum over deciding scorers
    std::string veto;           ///< first veto of a deciding scorer, with its name; empty: none
    Encounters encounters;      ///< of the deciding scorers
    std::vector<Score> scores;  ///< all scorers, in the order of `scorers()`
  };
  Verdict judge(const Hypothesis& hypothesis, const Observation& observation) const;

  /// What all scorers can say about a hypothesis in words, with their names.
  struct NamedFinding {
    std::string scorer;
    Finding finding;
  };
  std::vector<NamedFinding> explain(const Hypothesis& hypothesis, const Observation& observation) const;

  const std::vector<ActiveScorer>& scorers() const { return scorers_; }

 private:
  void count_failure(const ActiveScorer& scorer, const std::string& cause) const;
  Score ask(const ActiveScorer& scorer, const Hypothesis& hypothesis, const Observation& observation) const;

  std::vector<ActiveScorer> scorers_;
  std::shared_ptr<const MapView> map_;
  std::map<std::string, int>& failures_;
};

}  // namespace opal
