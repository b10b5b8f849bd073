#include "localization/scoring/scorer_ensemble.hpp"

#include <algorithm>
#include <cmath>

namespace opal {

ScorerEnsemble::ScorerEnsemble(std::vector<ActiveScorer> scorers, std::shared_ptr<const MapView> map,
                               PluginFailures& failures)
    : scorers_(std::move(scorers)), map_(std::move(map)), failures_(failures) {
  std::vector<ScorerMemories::Shared> memories(scorers_.size());
  for (std::size_t k = 0; k < scorers_.size(); ++k)
    usable_.push_back(failures_.guard(scorers_[k].name, [&] {
      memories[k] = scorers_[k].part->new_memory(*map_);
      judges_associations_ = scorers_[k].part->judges_associations() || judges_associations_;
    }));
  new_memories_ = ScorerMemories(std::move(memories));
}

void ScorerEnsemble::expect_finite(Score& score, const std::string& name) const {
  if (std::isfinite(score.log_likelihood)) return;
  failures_.count(name, "score is not finite");
  score = {};
}

std::vector<Score> ScorerEnsemble::ask(std::size_t number, Hypotheses hypotheses,
                                       const Observation& observation) const {
  std::vector<Score> nothing(hypotheses.size());
  if (!usable_[number] || hypotheses.empty()) return nothing;
  const ActiveScorer& scorer = scorers_[number];
  std::vector<const ScorerMemory*> memories;
  for (const Hypothesis* hypothesis : hypotheses) memories.push_back(memories_of(*hypothesis).of(number));
  std::vector<Score> scores;
  const auto call = [&] { scores = scorer.part->score_all(hypotheses, memories, observation, *map_); };
  if (!failures_.guard(scorer.name, call)) return nothing;
  if (scores.size() != hypotheses.size()) {
    failures_.count(scorer.name, "gave " + std::to_string(scores.size()) + " scores, expected " +
                                     std::to_string(hypotheses.size()) + ", one per hypothesis");
    return nothing;
  }
  for (Score& score : scores) expect_finite(score, scorer.name);
  return scores;
}

std::vector<ScorerEnsemble::NamedFinding> ScorerEnsemble::explain(const Hypothesis& hypothesis,
                                                                  const Observation& observation) const {
  constexpr std::size_t kMostFindings = 3;  // more of one scorer nobody reads
  std::vector<NamedFinding> all;
  for (std::size_t k = 0; k < scorers_.size(); ++k) {
    if (!usable_[k]) continue;
    const ActiveScorer& scorer = scorers_[k];
    std::vector<Finding> findings;
    failures_.guard(scorer.name, [&] { findings = scorer.part->explain(hypothesis, observation, *map_); });
    if (findings.size() > kMostFindings) findings.resize(kMostFindings);
    for (Finding& finding : findings) all.push_back({scorer.name, std::move(finding)});
  }
  return all;
}

double ScorerEnsemble::decide(const Hypothesis& hypothesis, const Observation& observation) const {
  const Hypothesis* only = &hypothesis;
  return decide_all({&only, 1}, observation).front();
}

std::vector<double> ScorerEnsemble::decide_all(Hypotheses hypotheses, const Observation& observation) const {
  std::vector<double> nats(hypotheses.size(), 0.0);
  for (std::size_t k = 0; k < scorers_.size(); ++k) {
    if (!scorers_[k].decides()) continue;
    const std::vector<Score> scores = ask(k, hypotheses, observation);
    for (std::size_t i = 0; i < nats.size(); ++i) nats[i] += scorers_[k].weight * scores[i].log_likelihood;
  }
  return nats;
}

void ScorerEnsemble::add(Verdict& verdict, std::size_t number, Score score) const {
  const ActiveScorer& scorer = scorers_[number];
  if (scorer.decides()) {
    verdict.nat += scorer.weight * score.log_likelihood;
    if (verdict.veto.empty() && !score.veto.empty()) verdict.veto = scorer.name + ": " + score.veto;
  }
  verdict.scores.push_back(std::move(score));
}

ScorerEnsemble::Verdict ScorerEnsemble::judge(const Hypothesis& hypothesis, const Observation& observation) const {
  const Hypothesis* only = &hypothesis;
  return std::move(judge_all({&only, 1}, observation).front());
}

std::vector<ScorerEnsemble::Verdict> ScorerEnsemble::judge_all(Hypotheses hypotheses,
                                                               const Observation& observation) const {
  std::vector<Verdict> verdicts(hypotheses.size());
  for (std::size_t k = 0; k < scorers_.size(); ++k) {
    std::vector<Score> scores = ask(k, hypotheses, observation);
    for (std::size_t i = 0; i < verdicts.size(); ++i) add(verdicts[i], k, std::move(scores[i]));
  }
  return verdicts;
}

void ScorerEnsemble::remember(Hypothesis& hypothesis, const std::vector<Score>& scores, double weight) const {
  if (hypothesis.memories.empty()) hypothesis.memories = new_memories_;
  for (std::size_t k = 0; k < scores.size(); ++k) {
    if (!scores[k].seen || !hypothesis.memories.of(k)) continue;
    failures_.guard(scorers_[k].name,
                    [&] { scorers_[k].part->remember(*hypothesis.memories.own(k), *scores[k].seen, weight); });
  }
}

void ScorerEnsemble::fade(Hypothesis& hypothesis, double weight) const {
  for (std::size_t k = 0; k < scorers_.size(); ++k) {
    if (!hypothesis.memories.of(k)) continue;
    failures_.guard(scorers_[k].name, [&] { scorers_[k].part->fade(*hypothesis.memories.own(k), weight); });
  }
}

}  // namespace opal
