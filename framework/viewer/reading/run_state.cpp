#include "viewer/reading/run_state.hpp"

#include <algorithm>
#include <set>

namespace opal {
namespace {

bool contains(const std::vector<LocalFeatureId>& ids, LocalFeatureId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

}  // namespace

void RunState::apply(const RunFrame& frame) {
  if (frame.starts) *this = RunState(paths_);
  if (frame.starts) time_line_ = *frame.starts;
  frame_ = frame;
  ++frames_;
  apply_local_features();
  for (const RecordedSpawn& spawn : frame_.spawns) insert(spawn);
  // What no longer fits is dropped before hypotheses grow; the same local feature may find another
  // counterpart.
  for (const RecordedLoss& loss : frame_.losses) lose(loss);
  for (const RecordedGrowth& growth : frame_.growths) grow(growth);
  for (const RecordedEnd& ending : frame_.ends) end(ending);
  take_estimate();
  forget_unlikely();
}

const TracedHypothesis* RunState::best() const {
  const auto found = alive_.find(frame_.best);
  return found == alive_.end() ? nullptr : &found->second;
}

void RunState::apply_local_features() {
  for (const RecordedLocalFeature& feature : frame_.changed) local_features_[feature.id] = feature;
  for (const LocalFeatureId id : frame_.gone) local_features_.erase(id);
}

TracedHypothesis& RunState::traced(HypothesisId id) {
  const auto [found, is_new] = alive_.try_emplace(id);
  if (is_new) {
    found->second.id = id;
    found->second.spawned_s = frame_.time_s;
    found->second.spawned_keyframe = frame_.keyframe;
  }
  return found->second;
}

void RunState::insert(const RecordedSpawn& spawn) {
  TracedHypothesis& hypothesis = traced(spawn.id);
  hypothesis.parent = spawn.parent;
  hypothesis.origin = spawn.origin;
  hypothesis.pairs = spawn.pairs;
  hypothesis.T_map_base = spawn.T_map_base;
  hypothesis.log_likelihood = spawn.log_likelihood;
}

void RunState::grow(const RecordedGrowth& growth) {
  std::vector<Association>& pairs = traced(growth.hypothesis).pairs;
  for (const Association& pair : growth.pairs) {
    std::erase_if(pairs, [&](const Association& old) {
      return old.local_feature == pair.local_feature && old.local_feature.exists();
    });
    pairs.push_back(pair);
  }
}

void RunState::lose(const RecordedLoss& loss) {
  std::erase_if(traced(loss.hypothesis).pairs,
                [&](const Association& pair) { return contains(loss.local_features, pair.local_feature); });
}

void RunState::end(const RecordedEnd& end) {
  TracedHypothesis& hypothesis = traced(end.id);
  hypothesis.T_map_base = end.T_map_base;
  hypothesis.log_likelihood = end.log_likelihood;
  hypothesis.scan_nat = end.scan_nat;
  ended_.push_back({std::move(hypothesis), end, frame_.time_s, frame_.keyframe});
  alive_.erase(end.id);
}

void RunState::take_estimate() {
  for (const RecordedHypothesis& row : frame_.hypotheses) {
    TracedHypothesis& hypothesis = traced(row.id);
    hypothesis.T_map_base = row.T_map_base;
    hypothesis.log_likelihood = row.log_likelihood;
    hypothesis.scan_nat = row.scan_nat;
    hypothesis.probability = row.probability;
    hypothesis.scores = row.scores;
    if (row.id == frame_.best) hypothesis.led_s = frame_.time_s;
    if (row.probability < hypothesis.highest_probability) continue;
    hypothesis.highest_probability = row.probability;
    hypothesis.highest_s = frame_.time_s;
  }
  if (alive_.size() > frame_.hypotheses.size()) keep_alive_only_listed();
  if (paths_ == Paths::left_out) return;
  if (const TracedHypothesis* winner = best()) trajectory_.push_back(winner->T_map_base.position());
  if (frame_.truth) truth_.push_back(frame_.truth->position());
}

/// A recording may lack the end of a hypothesis; what is alive is what the estimate lists.
void RunState::keep_alive_only_listed() {
  std::set<HypothesisId> listed;
  for (const RecordedHypothesis& row : frame_.hypotheses) listed.insert(row.id);
  std::erase_if(alive_, [&](const auto& entry) { return !listed.contains(entry.first); });
}

void RunState::forget_unlikely() {
  if (ended_.size() <= kMostEnded) return;
  std::vector<double> highest;
  for (const EndedHypothesis& each : ended_) highest.push_back(each.life.highest_probability);
  std::nth_element(highest.begin(), highest.begin() + kMostEnded / 2, highest.end(), std::greater<>());
  const double least = highest[kMostEnded / 2];
  const std::size_t newest = ended_.size() - kMostEnded / 4;  // these stay in any case
  std::vector<EndedHypothesis> kept;
  for (std::size_t k = 0; k < ended_.size(); ++k)
    if (k >= newest || ended_[k].life.highest_probability > least) kept.push_back(std::move(ended_[k]));
  ended_ = std::move(kept);
}

}  // namespace opal
