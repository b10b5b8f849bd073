#include "common/phrases.hpp"
#include "localization/decision/same_place.hpp"
#include "report/quantity_text.hpp"
#include "viewer/reading/id_format.hpp"
#include "viewer/words/score_comparison.hpp"
#include "viewer/words/sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace opal {
namespace {

constexpr double kLeastProbability = 0.01;
constexpr std::size_t kNamedAlternatives = 2, kNamedFallen = 2, kNamedFindings = 1;

std::vector<const TracedHypothesis*> alternatives_of(const TracedHypothesis& best, const RunState& state) {
  std::vector<const TracedHypothesis*> alternatives;
  for (const auto& [id, hypothesis] : state.alive())
    if (id != best.id && hypothesis.probability >= kLeastProbability &&
        !kSamePlace.holds(hypothesis.T_map_base, best.T_map_base))
      alternatives.push_back(&hypothesis);
  std::sort(alternatives.begin(), alternatives.end(), [](const auto* a, const auto* b) {
    return a->probability != b->probability ? a->probability > b->probability : a->id < b->id;
  });
  return alternatives;
}

std::string alternative_text(const TracedHypothesis& alternative, const TracedHypothesis& best) {
  return fmt::format("hypothesis {} at {} has probability {}: {}", alternative.id, pose_text(alternative.T_map_base),
                     probability_text(alternative.probability), comparison_text(alternative, best));
}

auto rank_of(const EndedHypothesis& ended) {
  return std::make_tuple(-ended.life.led_s.value_or(-1), -ended.life.highest_probability, -ended.end_s, ended.end.id);
}

/// Former best ones, the latest first; then those that were once the most probable. A hypothesis that ended because
/// another one is at its place has not fallen.
std::vector<const EndedHypothesis*> fallen_of(const RunState& state) {
  std::vector<const EndedHypothesis*> fallen;
  for (const EndedHypothesis& ended : state.ended())
    if (!ended.end.merged_into.exists() && (ended.life.led_s || ended.life.highest_probability >= kLeastProbability))
      fallen.push_back(&ended);
  std::sort(fallen.begin(), fallen.end(), [](const auto* a, const auto* b) { return rank_of(*a) < rank_of(*b); });
  return fallen;
}

std::string fallen_text(const EndedHypothesis& fallen) {
  const TracedHypothesis& life = fallen.life;
  std::string text =
      fmt::format("hypothesis {} at {} fell at {}: {}", fallen.end.id, place_text(fallen.end.T_map_base.position()),
                  seconds_text(fallen.end_s), fallen.end.reason);
  if (const std::string findings = findings_text(fallen.end.findings, kNamedFindings); !findings.empty())
    text += "; " + findings;
  text += "; it had " + probability_text(life.highest_probability) + " at " + seconds_text(life.highest_s);
  return life.led_s ? text + " and was the best until " + seconds_text(*life.led_s) : text;
}

}  // namespace

std::string findings_text(const std::vector<RecordedFinding>& findings, std::size_t most) {
  std::string text;
  for (std::size_t k = 0; k < std::min(most, findings.size()); ++k) text += (k ? "; " : "") + findings[k].words;
  if (findings.size() > most) text += "; and " + count_of(findings.size() - most, "more finding");
  return text;
}

void add_alternatives(const ExplainedMoment& moment, std::vector<Sentence>& sentences) {
  const TracedHypothesis* best = moment.state.best();
  if (!best) return;
  const auto alternatives = alternatives_of(*best, moment.state);
  for (std::size_t k = 0; k < std::min(kNamedAlternatives, alternatives.size()); ++k)
    sentences.push_back({SentenceKind::alternative, alternative_text(*alternatives[k], *best)});
  if (alternatives.size() > kNamedAlternatives)
    sentences.push_back(
        {SentenceKind::alternative, count_of(alternatives.size() - kNamedAlternatives, "more alternative") +
                                        " with at least " + probability_text(kLeastProbability)});
}

void add_fallen(const ExplainedMoment& moment, std::vector<Sentence>& sentences) {
  const auto fallen = fallen_of(moment.state);
  for (std::size_t k = 0; k < std::min(kNamedFallen, fallen.size()); ++k)
    sentences.push_back({SentenceKind::fell, fallen_text(*fallen[k])});
}

}  // namespace opal
