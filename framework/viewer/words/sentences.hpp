#pragma once

#include "viewer/words/explained_moment.hpp"
#include "viewer/words/explanation.hpp"

namespace opal {

/// The recorded words of the first `most` findings, which are the weightiest, and the number of the rest.
std::string findings_text(const std::vector<RecordedFinding>& findings, std::size_t most);

/// The parts of an explanation, in its order; each adds its sentences, or none if there is nothing to say.

/// Status, place and probability; what it waits for while it is not localized.
void add_answer(const ExplainedMoment& moment, std::vector<Sentence>& sentences);
/// What the best hypothesis rests on, with distances as they are now, and where it comes from.
void add_support(const ExplainedMoment& moment, std::vector<Sentence>& sentences);
/// What scorers recorded against the best hypothesis, in their words.
void add_findings(const ExplainedMoment& moment, std::vector<Sentence>& sentences);
/// Living alternatives, and what they score less than the best one.
void add_alternatives(const ExplainedMoment& moment, std::vector<Sentence>& sentences);
/// Former best and once probable hypotheses that ended, with the recorded reason.
void add_fallen(const ExplainedMoment& moment, std::vector<Sentence>& sentences);
/// Local features that the best hypothesis takes for not on the map.
void add_unmapped(const ExplainedMoment& moment, std::vector<Sentence>& sentences);
/// While it does not know where it is: what it looked for, and what is missing. And the recorded truth.
void add_search(const ExplainedMoment& moment, std::vector<Sentence>& sentences);

}  // namespace opal
