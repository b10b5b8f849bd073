#include "viewer/words/explanation.hpp"

#include "viewer/words/explained_moment.hpp"
#include "viewer/words/sentences.hpp"

namespace opal {

const char* name_of(SentenceKind kind) {
  switch (kind) {
    case SentenceKind::answer: return "answer";
    case SentenceKind::support: return "support";
    case SentenceKind::against: return "against";
    case SentenceKind::alternative: return "alternative";
    case SentenceKind::fell: return "fell";
    case SentenceKind::note: return "note";
  }
  return "";
}

std::vector<std::pair<std::string, std::string>> words_of(const std::vector<Sentence>& sentences) {
  std::vector<std::pair<std::string, std::string>> words;
  for (const Sentence& sentence : sentences) words.emplace_back(name_of(sentence.kind), sentence.text);
  return words;
}

Explainer::Explainer(const RunHeader& header) : moment_(std::make_unique<ExplainedMoment>(header)) {}
Explainer::~Explainer() = default;
Explainer::Explainer(Explainer&&) noexcept = default;
Explainer& Explainer::operator=(Explainer&&) noexcept = default;

void Explainer::take(const RunFrame& frame) { moment_->take(frame); }

const RunState& Explainer::state() const { return moment_->state; }

std::vector<Sentence> Explainer::explanation() const {
  std::vector<Sentence> sentences;
  if (moment_->state.empty()) return sentences;
  add_answer(*moment_, sentences);
  add_support(*moment_, sentences);
  add_findings(*moment_, sentences);
  add_alternatives(*moment_, sentences);
  add_fallen(*moment_, sentences);
  add_search(*moment_, sentences);
  add_unmapped(*moment_, sentences);
  return sentences;
}

}  // namespace opal
