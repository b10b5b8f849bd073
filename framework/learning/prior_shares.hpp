#pragma once

#include <array>
#include <span>

namespace opal {

/// How likely visits are to say what they said of one thing, if it is ..., up to a factor: as mapped, moved, gone.
using VerdictLikelihood = std::array<double, 3>;

/// Shares of the objects that are as mapped, moved, gone. Before anybody drove: 0.90, 0.05, 0.05, as if twenty objects
/// had been seen; each object that drives have seen counts as one more. So one look at an object changes a good map
/// less than one that has turned out to be wrong in many places.
VerdictLikelihood prior_shares(std::span<const VerdictLikelihood> objects);

/// Share of the straight faces that the map lacks and that stand there for good: 0.10 before anybody drove, as if
/// twenty had been seen. @param odds_nat  of faces that more than one visit has seen: how much likelier it is that
/// visits say what they said if the face stands there for good than if it does not; its logarithm.
double prior_share_of_additions(std::span<const double> odds_nat);

/// [nat] Of many visits, odds themselves are too large for a number.
double log_odds(double probability);
double probability_of(double log_odds);

}  // namespace opal
