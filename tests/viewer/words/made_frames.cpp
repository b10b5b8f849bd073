#include "made_frames.hpp"

using namespace opal;

RunHeader hall() {
  RunHeader header;
  header.objects = {{"wall-1", "opal:Wall"}, {"A.008", "opal:Column"}, {"B", "acme:Column"}};
  header.features = {{"wall-1/face", MapObjectNumber(0), "opal:Wall", true, Segment{{10, 0}, {0, 0}}},
                     {"A.008/rim", MapObjectNumber(1), "opal:Column", true, Circle{{2, -3}, 0.3}},
                     {"B/rim", MapObjectNumber(2), "opal:Column", true, Circle{{8, -3}, 0.3}}};
  return header;
}

RunFrame frame_at(double time_s, const std::string& status, double probability, double none) {
  RunFrame frame;
  if (time_s == 0) frame.starts = "run";
  frame.keyframe = KeyframeId(static_cast<int>(10 * time_s));
  frame.time_s = time_s;
  frame.stamp_s = 1000 + time_s;
  frame.T_local_base = Pose2(4, -2, 0.5);
  frame.status = status;
  frame.probability = probability;
  frame.none = none;
  return frame;
}

RecordedHypothesis hypothesis(int id, const Pose2& T_map_base, double probability, double nat,
                              std::vector<RecordedTerm> scores) {
  return {HypothesisId(id), T_map_base, nat, 1.0, probability, std::move(scores)};
}

RunFrame with(RunFrame frame, std::vector<RecordedHypothesis> hypotheses) {
  frame.hypotheses = std::move(hypotheses);
  frame.best = frame.hypotheses.empty() ? HypothesisId() : frame.hypotheses.front().id;
  return frame;
}

std::vector<std::string> sentences_of(SentenceKind kind, const std::vector<RunFrame>& frames) {
  const RunHeader header = hall();
  Explainer explainer(header);
  for (const RunFrame& frame : frames) explainer.take(frame);
  std::vector<std::string> texts;
  for (const Sentence& sentence : explainer.explanation())
    if (sentence.kind == kind) texts.push_back(sentence.text);
  return texts;
}
