#include <opal/localization/scoring/hypothesis_scorer.hpp>

namespace opal {

HypothesisScorer::~HypothesisScorer() = default;

std::unique_ptr<ScorerMemory> HypothesisScorer::new_memory(const MapView&) const { return nullptr; }

Score HypothesisScorer::score_new(const Hypothesis& hypothesis, const Observation& observation,
                                  const MapView& map) const {
  return score(hypothesis, observation, map, new_memory(map).get());
}

std::vector<Score> HypothesisScorer::score_all(std::span<const Hypothesis* const> hypotheses,
                                               std::span<const ScorerMemory* const> memories,
                                               const Observation& observation, const MapView& map) const {
  std::vector<Score> scores;
  scores.reserve(hypotheses.size());
  for (std::size_t k = 0; k < hypotheses.size(); ++k)
    scores.push_back(score(*hypotheses[k], observation, map, memories[k]));
  return scores;
}

void HypothesisScorer::remember(ScorerMemory&, const ScorerMemory&, double) const {}
void HypothesisScorer::fade(ScorerMemory&, double) const {}
bool HypothesisScorer::judges_associations() const { return true; }
std::vector<Finding> HypothesisScorer::explain(const Hypothesis&, const Observation&, const MapView&) const {
  return {};
}

}  // namespace opal
