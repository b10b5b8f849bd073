#include "localization/tree/hypothesis_set.hpp"

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

/// log(exp(a) + exp(b)).
double sum_of_nat(double a, double b) {
  const double most = std::max(a, b);
  return most + std::log1p(std::exp(-std::abs(a - b)));
}

}  // namespace

// One step of a Markov chain over the storeys that a lift serves. What was met before the ride was met elsewhere, so
// every hypothesis that takes part begins with an empty memory, also the one that stays: none shall gain by forgetting.
void HypothesisSet::carry(const Elsewhere& elsewhere, const Pose2& T_local_base) {
  struct Arrival {
    HypothesisId from;
    Pose2 T_map_base;
    RetrospectiveVerification::Verdict past;
  };
  std::vector<Arrival> arrivals;
  comparison_.clear();
  for (Live& live : alive_) {
    live.compared_nat = 0;  // what places have lost by comparisons before the ride stays lost
    const std::vector<Pose2> poses = elsewhere(live.hypothesis.T_map_local * T_local_base);
    if (poses.empty()) continue;
    live.hypothesis.log_likelihood -= std::log(1 + static_cast<double>(poses.size()));
    RetrospectiveVerification::Verdict past;
    past.nat = live.hypothesis.log_likelihood;
    past.kidnapped_after = live.kidnapped_after;
    past.inherited_nat = live.inherited_nat;
    for (const Pose2& pose : poses) arrivals.push_back({live.hypothesis.id, pose, past});
    live.hypothesis.memories = {};
    live.ridden_nat = live.hypothesis.log_likelihood;
  }
  for (Arrival& arrival : arrivals) {
    Candidate candidate;
    candidate.T_map_base = arrival.T_map_base;
    candidate.origin = Origin::ride;
    if (Live* there = at_place_of(candidate, T_local_base)) {
      there->hypothesis.log_likelihood = sum_of_nat(there->hypothesis.log_likelihood, arrival.past.nat);
      there->ridden_nat = there->hypothesis.log_likelihood;
      continue;
    }
    Live live;
    live.hypothesis.T_map_local = arrival.T_map_base * T_local_base.inverse();
    live.ridden_nat = arrival.past.nat;
    const double nat = arrival.past.nat;
    insert(std::move(live), {std::move(arrival.past), nat}, std::move(candidate), arrival.from);
  }
  prune();
}

}  // namespace opal
