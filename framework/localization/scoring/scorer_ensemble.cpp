#include "localization/scoring/scorer_ensemble.hpp"

#include <algorithm>
#include <cmath>

namespace opal {

ScorerEnsemble::ScorerEnsemble(std::vector<ActiveScorer> scorers, std::shared_ptr<const MapView> map,
                               PluginFailures& failures)
    : scorers_(std::move(scorers)), map_(std::move(map)), failures_(failures) {
  std::vector<ScorerMemories::Shared> memories(scorers_.size());
  for (std::size_t k = 0; k < scorers_.size(); ++k)
    usable_.push_back(failures_.guard(scorers_[k].name, [&] { memories[k] = scorers_[k].part->new_memory(*map_); }));
  new_memories_ = ScorerMemories(std::move(memories));
  for (std::size_t k = 0; k < scorers_.size(); ++k) {
    const HypothesisScorer* scorer = scorers_[k].part.get();
    const bool remembers = new_memories_.of(k) != nullptr;
    batches_.push_back(remembers ? nullptr : dynamic_cast<const BatchScorer*>(scorer));
    remembering_.push_back(remembers ? dynamic_cast<const RememberingBatchScorer*>(scorer) : nullptr);
  }
}

Score ScorerEnsemble::ask(std::size_t number, const Hypothesis& hypothesis, const Observation& observation) const {
  if (!usable_[number]) return {};
  const ActiveScorer& scorer = scorers_[number];
  Score score;
  const auto call = [&] {
    score = scorer.part->score(hypothesis, observation, *map_, memories_of(hypothesis).of(number));
  };
  if (!failures_.guard(scorer.name, call)) return {};
  expect_finite(score, scorer.name);
  return score;
}

void ScorerEnsemble::expect_finite(Score& score, const std::string& name) const {
  if (std::isfinite(score.log_likelihood)) return;
  failures_.count(name, "score is not finite");
  score = {};
}

std::vector<Score> ScorerEnsemble::ask_in_one_call(std::size_t number, Hypotheses hypotheses,
                                                   const Observation& observation) const {
  if (batches_[number] != nullptr) return batches_[number]->score_all(hypotheses, observation, *map_);
  std::vector<const ScorerMemory*> memories;
  for (const Hypothesis* hypothesis : hypotheses) memories.push_back(memories_of(*hypothesis).of(number));
  return remembering_[number]->score_all(hypotheses, memories, observation, *map_);
}

std::vector<Score> ScorerEnsemble::ask_all(std::size_t number, Hypotheses hypotheses,
                                           const Observation& observation) const {
  std::vector<Score> scores;
  if (!takes_many(number)) {
    for (const Hypothesis* hypothesis : hypotheses) scores.push_back(ask(number, *hypothesis, observation));
    return scores;
  }
  const std::string& name = scorers_[number].name;
  const auto call = [&] { scores = ask_in_one_call(number, hypotheses, observation); };
  if (!usable_[number] || hypotheses.empty() || !failures_.guard(name, call))
    return std::vector<Score>(hypotheses.size());
  if (scores.size() != hypotheses.size()) {
    failures_.count(name, "gave " + std::to_string(scores.size()) + " scores, expected " +
                              std::to_string(hypotheses.size()) + ", one per hypothesis");
    return std::vector<Score>(hypotheses.size());
  }
  for (Score& score : scores) expect_finite(score, name);
  return scores;
}

std::vector<ScorerEnsemble::NamedFinding> ScorerEnsemble::explain(const Hypothesis& hypothesis,
                                                                  const Observation& observation) const {
  std::vector<NamedFinding> all;
  for (const ActiveScorer& scorer : scorers_) {
    std::vector<Finding> findings;
    failures_.guard(scorer.name, [&] { findings = scorer.part->explain(hypothesis, observation, *map_); });
    for (Finding& finding : findings) all.push_back({scorer.name, std::move(finding)});
  }
  return all;
}

bool ScorerEnsemble::judges_associations() const {
  return std::any_of(scorers_.begin(), scorers_.end(),
                     [](const ActiveScorer& s) { return s.part->judges_associations(); });
}

double ScorerEnsemble::decide(const Hypothesis& hypothesis, const Observation& observation) const {
  double nat = 0;
  for (std::size_t k = 0; k < scorers_.size(); ++k)
    if (scorers_[k].decides()) nat += scorers_[k].weight * ask(k, hypothesis, observation).log_likelihood;
  return nat;
}

std::vector<double> ScorerEnsemble::decide_all(Hypotheses hypotheses, const Observation& observation) const {
  std::vector<double> nats(hypotheses.size(), 0.0);
  for (std::size_t k = 0; k < scorers_.size(); ++k) {
    const double weight = scorers_[k].weight;
    if (!scorers_[k].decides()) continue;
    if (takes_many(k)) {
      const std::vector<Score> scores = ask_all(k, hypotheses, observation);
      for (std::size_t i = 0; i < nats.size(); ++i) nats[i] += weight * scores[i].log_likelihood;
    } else {  // what a scorer adds to its memory is dropped at once: there may be many
      for (std::size_t i = 0; i < nats.size(); ++i)
        nats[i] += weight * ask(k, *hypotheses[i], observation).log_likelihood;
    }
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
  Verdict verdict;
  for (std::size_t k = 0; k < scorers_.size(); ++k) add(verdict, k, ask(k, hypothesis, observation));
  return verdict;
}

std::vector<ScorerEnsemble::Verdict> ScorerEnsemble::judge_all(Hypotheses hypotheses,
                                                               const Observation& observation) const {
  std::vector<Verdict> verdicts(hypotheses.size());
  for (std::size_t k = 0; k < scorers_.size(); ++k) {
    std::vector<Score> scores = ask_all(k, hypotheses, observation);
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
