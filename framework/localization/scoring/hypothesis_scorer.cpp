#include <opal/localization/scoring/batch_scorer.hpp>
#include <opal/localization/scoring/hypothesis_scorer.hpp>

namespace opal {

BatchScorer::~BatchScorer() = default;
RememberingBatchScorer::~RememberingBatchScorer() = default;
HypothesisScorer::~HypothesisScorer() = default;

std::unique_ptr<ScorerMemory> HypothesisScorer::new_memory(const MapView&) const { return nullptr; }

Score HypothesisScorer::score_new(const Hypothesis& hypothesis, const Observation& observation,
                                  const MapView& map) const {
  return score(hypothesis, observation, map, new_memory(map).get());
}

void HypothesisScorer::remember(ScorerMemory&, const ScorerMemory&, double) const {}
void HypothesisScorer::fade(ScorerMemory&, double) const {}
bool HypothesisScorer::judges_associations() const { return true; }
std::vector<Finding> HypothesisScorer::explain(const Hypothesis&, const Observation&, const MapView&) const {
  return {};
}

}  // namespace opal
