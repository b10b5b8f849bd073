#include <opal/localization/scoring/hypothesis_scorer.hpp>

namespace opal {

HypothesisScorer::~HypothesisScorer() = default;
bool HypothesisScorer::judges_associations() const { return true; }
std::vector<Finding> HypothesisScorer::explain(const Hypothesis&, const Observation&, const MapView&) const { return {}; }

}  // namespace opal
