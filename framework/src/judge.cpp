#include "judge.hpp"

#include <spdlog/spdlog.h>

#include <cmath>

namespace opal {

Score Judge::ask(const ActiveScorer& scorer, const Hypothesis& hypothesis, const Observation& observation) const {
  std::string cause;
  try {
    Score score = scorer.part->score(hypothesis, observation, *map_);
    if (std::isfinite(score.log_likelihood)) return score;
    cause = "score is not finite";
  } catch (const std::exception& error) {
    cause = error.what();
  } catch (...) {
    cause = "threw something that is no std::exception";
  }
  if (failures_[scorer.name]++ == 0) spdlog::warn("{}: skipped: {}", scorer.name, cause);
  return {};
}

double Judge::decide(const Hypothesis& hypothesis, const Observation& observation) const {
  double nat = 0;
  for (const ActiveScorer& scorer : scorers_)
    if (scorer.decides) nat += scorer.weight * ask(scorer, hypothesis, observation).log_likelihood;
  return nat;
}

Judge::Verdict Judge::judge(const Hypothesis& hypothesis, const Observation& observation) const {
  Verdict verdict;
  for (const ActiveScorer& scorer : scorers_) {
    Score score = ask(scorer, hypothesis, observation);
    if (scorer.decides) {
      verdict.nat += scorer.weight * score.log_likelihood;
      if (verdict.veto.empty() && !score.veto.empty()) verdict.veto = scorer.name + ": " + score.veto;
    }
    verdict.scores.push_back(std::move(score));
  }
  return verdict;
}

}  // namespace opal
