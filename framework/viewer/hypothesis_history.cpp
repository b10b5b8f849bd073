#include "viewer/hypothesis_history.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace opal {
namespace {

constexpr std::size_t kFallenKept = 8;
/// Below this a hypothesis was never worth a word.
constexpr double kLeastProbability = 0.01;

bool mattered_more(const FallenHypothesis& a, const FallenHypothesis& b) {
  const auto rank = [](const FallenHypothesis& fallen) {
    return std::make_tuple(-fallen.history.led_s.value_or(-1), -fallen.history.highest_probability, -fallen.fell_s,
                           fallen.end.id);
  };
  return rank(a) < rank(b);
}

const Pose2* best_pose(const RunFrame& frame) {
  for (const RecordedHypothesis& hypothesis : frame.hypotheses)
    if (hypothesis.id == frame.best) return &hypothesis.T_map_base;
  return nullptr;
}

}  // namespace

bool same_place(const Pose2& a, const Pose2& b) {
  constexpr double kSamePlace_m = 0.7, kSamePlace_rad = 0.2;
  return distance_m(a, b) < kSamePlace_m && angle_between_rad(a, b) < kSamePlace_rad;
}

const HypothesisHistory* HypothesisHistories::alive(int hypothesis) const {
  const auto it = alive_.find(hypothesis);
  return it == alive_.end() ? nullptr : &it->second;
}

/// In the order of the pipeline: a search gives birth, associations end, then they grow.
void HypothesisHistories::take(const RunFrame& frame) {
  if (frame.starts) *this = {};
  for (const RecordedBirth& birth : frame.births) take_birth(birth, frame.time_s);
  for (const RecordedLoss& loss : frame.losses)
    for (int local : loss.local_features) alive_[loss.hypothesis].pairs.erase(local);
  for (const RecordedGrowth& growth : frame.growths)
    for (const RecordedPair& pair : growth.pairs)
      alive_[growth.hypothesis].pairs[pair.local_feature] = pair.map_feature;
  for (const RecordedEnd& end : frame.ends) take_end(end, frame);
  take_estimate(frame);
}

void HypothesisHistories::take_birth(const RecordedBirth& birth, double time_s) {
  HypothesisHistory& history = alive_[birth.id];
  history.birth = birth;
  history.born_s = time_s;
  history.pairs.clear();
  for (const RecordedPair& pair : birth.pairs)
    if (pair.local_feature >= 0) history.pairs[pair.local_feature] = pair.map_feature;
}

void HypothesisHistories::take_end(const RecordedEnd& end, const RunFrame& frame) {
  const auto it = alive_.find(end.id);
  if (it == alive_.end()) return;
  const HypothesisHistory history = std::move(it->second);
  alive_.erase(it);
  const bool mattered = history.led_s || history.highest_probability >= kLeastProbability;
  if (end.merged_into >= 0 || !mattered) return;
  const Pose2* best = best_pose(frame);
  fallen_.push_back({history, end, frame.time_s, best && same_place(*best, end.T_map_base)});
  std::sort(fallen_.begin(), fallen_.end(), mattered_more);
  if (fallen_.size() > kFallenKept) fallen_.pop_back();
}

/// Whoever is not in the estimate is not alive, whatever else a damaged stream says.
void HypothesisHistories::take_estimate(const RunFrame& frame) {
  std::set<int> estimated;
  for (const RecordedHypothesis& hypothesis : frame.hypotheses) estimated.insert(hypothesis.id);
  std::erase_if(alive_, [&](const auto& entry) { return !estimated.contains(entry.first); });
  for (const RecordedHypothesis& hypothesis : frame.hypotheses) {
    HypothesisHistory& history = alive_[hypothesis.id];
    if (hypothesis.id == frame.best) history.led_s = frame.time_s;
    if (hypothesis.probability <= history.highest_probability) continue;
    history.highest_probability = hypothesis.probability;
    history.highest_s = frame.time_s;
  }
}

}  // namespace opal
