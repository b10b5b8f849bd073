#pragma once

#include "benchmark/ab/documents/experiment.hpp"
#include "benchmark/ab/records/ranking_tally.hpp"
#include "common/digest/sha256.hpp"

#include <opal/localization/localizer.hpp>
#include "evaluation/ground_truth.hpp"

namespace opal::benchmark {

/// A scorer of the arm that observes.
struct ObservedScorer {
  std::string name;  ///< by which the localizer knows its scores
  double weight = 1;
};

/// Puts an arm's deciding scorers beside those of a deployment, as observers.
/// @param decides  the arm's scorers are the deployment's own: they are only to be looked at.
std::vector<ObservedScorer> let_observe(opal::Deployment& deployment, const opal::ab::Arm& arm, bool decides);

/// Looks at a run after every update: how do these scorers rank the hypotheses that are alive?
class RankedRun {
 public:
  RankedRun(const opal::Localizer& localizer, const opal::GroundTruth& truth, const opal::Pose2& T_base_laser,
            const std::vector<ObservedScorer>& scorers)
      : localizer_(localizer), truth_(truth), T_base_laser_(T_base_laser), scorers_(scorers) {}

  void look(double stamp_s);
  std::map<std::string, double> values() const { return tally_.values(); }
  /// Of all hypotheses that were judged: the same in every arm, if observers change nothing.
  std::string digest();

 private:
  double judged_nat(opal::HypothesisId hypothesis) const;

  const opal::Localizer& localizer_;
  const opal::GroundTruth& truth_;
  opal::Pose2 T_base_laser_;
  const std::vector<ObservedScorer>& scorers_;
  opal::ab::RankingTally tally_;
  opal::Sha256 seen_;
};

}  // namespace opal::benchmark
