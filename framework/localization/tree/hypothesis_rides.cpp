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
    double nat;
  };
  std::vector<Arrival> arrivals;
  for (Live& live : alive_) {
    const std::vector<Pose2> poses = elsewhere(live.hypothesis.T_map_local * T_local_base);
    if (poses.empty()) continue;
    live.hypothesis.log_likelihood -= std::log(1 + static_cast<double>(poses.size()));
    for (const Pose2& pose : poses) arrivals.push_back({live.hypothesis.id, pose, live.hypothesis.log_likelihood});
    live.hypothesis.memories = {};
    live.ridden_nat = live.hypothesis.log_likelihood;
  }
  for (const Arrival& arrival : arrivals) {
    Candidate candidate;
    candidate.T_map_base = arrival.T_map_base;
    if (Live* there = at_place_of(candidate, T_local_base)) {
      there->hypothesis.log_likelihood = sum_of_nat(there->hypothesis.log_likelihood, arrival.nat);
      continue;
    }
    Live live;
    live.hypothesis.T_map_local = arrival.T_map_base * T_local_base.inverse();
    live.ridden_nat = arrival.nat;
    insert(std::move(live), {{}, arrival.nat}, std::move(candidate), arrival.from);
  }
  prune();
}

}  // namespace opal
