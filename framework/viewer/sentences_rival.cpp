#include "viewer/quantity_text.hpp"
#include "viewer/score_comparison.hpp"
#include "viewer/sentences.hpp"

#include <algorithm>

namespace opal {
namespace {

constexpr double kLeastProbability = 0.01;
constexpr std::size_t kNamedRivals = 2, kNamedFallen = 2, kNamedFindings = 1;

std::vector<const RecordedHypothesis*> rivals_of(const RecordedHypothesis& best, const RunFrame& frame) {
  std::vector<const RecordedHypothesis*> rivals;
  for (const RecordedHypothesis& hypothesis : frame.hypotheses)
    if (hypothesis.id != best.id && hypothesis.probability >= kLeastProbability &&
        !same_place(hypothesis.T_map_base, best.T_map_base))
      rivals.push_back(&hypothesis);
  std::sort(rivals.begin(), rivals.end(), [](const auto* a, const auto* b) {
    return a->probability != b->probability ? a->probability > b->probability : a->id < b->id;
  });
  return rivals;
}

std::string rival_text(const RecordedHypothesis& rival, const RecordedHypothesis& best) {
  return "hypothesis " + std::to_string(rival.id) + " at " + pose_text(rival.T_map_base) + " has probability " +
         probability_text(rival.probability) + ": " + comparison_text(rival, best);
}

std::string fallen_text(const FallenHypothesis& fallen) {
  const HypothesisHistory& history = fallen.history;
  std::string text = "hypothesis " + std::to_string(fallen.end.id) + " at " +
                     place_text(fallen.end.T_map_base.position()) + " fell at " + seconds_text(fallen.fell_s) + ": " +
                     fallen.end.reason;
  if (const std::string findings = findings_text(fallen.end.findings, kNamedFindings); !findings.empty())
    text += "; " + findings;
  text += "; it had " + probability_text(history.highest_probability) + " at " + seconds_text(history.highest_s);
  if (history.led_s) text += " and was the best until " + seconds_text(*history.led_s);
  return text;
}

}  // namespace

std::string findings_text(const std::vector<RecordedFinding>& findings, std::size_t most) {
  std::string text;
  for (std::size_t k = 0; k < std::min(most, findings.size()); ++k) text += (k ? "; " : "") + findings[k].words;
  if (findings.size() > most) text += "; and " + count_text(findings.size() - most, "more finding");
  return text;
}

void add_rivals(const ExplainedMoment& moment, std::vector<Sentence>& sentences) {
  const RecordedHypothesis* best = moment.best();
  if (!best) return;
  const auto rivals = rivals_of(*best, moment.frame);
  for (std::size_t k = 0; k < std::min(kNamedRivals, rivals.size()); ++k)
    sentences.push_back({SentenceKind::rival, rival_text(*rivals[k], *best)});
  if (rivals.size() > kNamedRivals)
    sentences.push_back({SentenceKind::rival, count_text(rivals.size() - kNamedRivals, "more rival") +
                                                  " with at least " + probability_text(kLeastProbability)});
}

void add_fallen(const ExplainedMoment& moment, std::vector<Sentence>& sentences) {
  std::size_t named = 0;
  for (const FallenHypothesis& fallen : moment.histories.fallen()) {
    if (fallen.beside_best || named == kNamedFallen) continue;
    sentences.push_back({SentenceKind::fell, fallen_text(fallen)});
    ++named;
  }
}

}  // namespace opal
