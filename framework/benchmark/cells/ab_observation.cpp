#include "benchmark/cells/ab_observation.hpp"

#include "evaluation/pose_tolerance.hpp"

namespace opal::benchmark {

std::vector<ObservedScorer> let_observe(opal::Deployment& deployment, const opal::ab::Arm& arm, bool decides) {
  std::vector<ObservedScorer> observed;
  for (opal::ScorerConfig scorer : arm.deployment.scorers) {
    if (!scorer.decides()) continue;
    const std::string type = scorer.part.type;
    observed.push_back({decides ? type : arm.name + ": " + type, scorer.weight});
    if (decides) continue;
    scorer.role = opal::ScorerRole::observes;
    scorer.name = observed.back().name;
    deployment.scorers.push_back(std::move(scorer));
  }
  return observed;
}

double RankedRun::judged_nat(opal::HypothesisId hypothesis) const {
  const std::map<std::string, opal::Score> scores = localizer_.scores_of(hypothesis);
  double nat = 0;
  for (const ObservedScorer& scorer : scorers_)
    if (const auto found = scores.find(scorer.name); found != scores.end())
      nat += scorer.weight * found->second.log_likelihood;
  return nat;
}

void RankedRun::look(double stamp_s) {
  const auto T_map_laser = truth_.T_map_laser_at(stamp_s);
  if (!T_map_laser) return;
  std::vector<opal::ab::RankedHypothesis> ranked;
  for (const opal::Hypothesis& hypothesis : localizer_.hypotheses()) {
    const opal::Pose2 said = hypothesis.T_map_local * localizer_.local_map().T_local_base() * T_base_laser_;
    ranked.push_back({judged_nat(hypothesis.id), opal::kRightPose.holds(said, *T_map_laser)});
    const double pose[] = {said.x(), said.y(), said.heading_rad()};
    seen_.add({reinterpret_cast<const char*>(pose), sizeof pose});
  }
  tally_.add(ranked);
}

std::string RankedRun::digest() {
  constexpr std::size_t kDigits = 16;
  return seen_.finish().substr(0, kDigits);
}

}  // namespace opal::benchmark
