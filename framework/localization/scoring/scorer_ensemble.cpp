#include "localization/scoring/scorer_ensemble.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

namespace opal {

namespace {

/// Calls into a plugin; what it throws becomes a cause in words. Empty: it went well.
template <class Call>
std::string cause_of_failure(Call&& call) {
  try {
    call();
    return {};
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "threw something that is no std::exception";
  }
}

}  // namespace

void ScorerEnsemble::count_failure(const ActiveScorer& scorer, const std::string& cause) const {
  if (failures_[scorer.name]++ == 0) spdlog::warn("{}: skipped: {}", scorer.name, cause);
}

Score ScorerEnsemble::ask(const ActiveScorer& scorer, const Hypothesis& hypothesis, const Observation& observation) const {
  Score score;
  std::string cause = cause_of_failure([&] { score = scorer.part->score(hypothesis, observation, *map_); });
  if (cause.empty() && !std::isfinite(score.log_likelihood)) cause = "score is not finite";
  if (cause.empty()) return score;
  count_failure(scorer, cause);
  return {};
}

std::vector<ScorerEnsemble::NamedFinding> ScorerEnsemble::explain(const Hypothesis& hypothesis, const Observation& observation) const {
  std::vector<NamedFinding> all;
  for (const ActiveScorer& scorer : scorers_) {
    std::vector<Finding> findings;
    const std::string cause =
        cause_of_failure([&] { findings = scorer.part->explain(hypothesis, observation, *map_); });
    if (!cause.empty()) count_failure(scorer, cause);
    for (Finding& finding : findings) all.push_back({scorer.name, std::move(finding)});
  }
  return all;
}

bool ScorerEnsemble::judges_associations() const {
  return std::any_of(scorers_.begin(), scorers_.end(), [](const ActiveScorer& s) { return s.part->judges_associations(); });
}

double ScorerEnsemble::decide(const Hypothesis& hypothesis, const Observation& observation) const {
  double nat = 0;
  for (const ActiveScorer& scorer : scorers_)
    if (scorer.decides) nat += scorer.weight * ask(scorer, hypothesis, observation).log_likelihood;
  return nat;
}

ScorerEnsemble::Verdict ScorerEnsemble::judge(const Hypothesis& hypothesis, const Observation& observation) const {
  Verdict verdict;
  for (const ActiveScorer& scorer : scorers_) {
    Score score = ask(scorer, hypothesis, observation);
    if (scorer.decides) {
      verdict.nat += scorer.weight * score.log_likelihood;
      verdict.encounters.take(score.encounters, 1, 1);
      if (verdict.veto.empty() && !score.veto.empty()) verdict.veto = scorer.name + ": " + score.veto;
    }
    verdict.scores.push_back(std::move(score));
  }
  return verdict;
}

}  // namespace opal
