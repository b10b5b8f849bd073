// What a localizer is asked between updates.
#include "localization/localizer_state.hpp"

namespace opal {

std::vector<LocalFeatureId> Localizer::State::pattern_of_best() const {
  std::vector<LocalFeatureId> features;
  for (const Association& pair : hypotheses.tree().first_pairs(hypotheses.alive().front().leaf))
    features.push_back(pair.local_feature);
  return features;
}

Localizer::Localizer(LocalizerParts parts, EventSink* events)
    : state_(std::make_unique<State>(std::move(parts), events)) {}
Localizer::~Localizer() = default;

PoseEstimate Localizer::estimate_at(double stamp_s, const Pose2& T_odom_base) const {
  const Pose2 T_local_base =
      state_->local_map.T_local_base_at(state_->laser_odometry.at(state_->odometry.at(T_odom_base)));
  return state_->with_place(state_->status.at(stamp_s, T_local_base));
}

void Localizer::hint(const PoseHint& hint) { state_->search_session.hint(hint); }

void Localizer::reset() { state_->reset(); }

void Localizer::keep_pattern() {
  if (!state_->hypotheses.alive().empty()) state_->local_map.keep_only(state_->pattern_of_best());
}

const LocalMap& Localizer::local_map() const { return state_->local_map; }
const MapView& Localizer::map() const { return *state_->parts.map; }

std::vector<Hypothesis> Localizer::hypotheses() const {
  std::vector<Hypothesis> alive;
  for (const Live& live : state_->hypotheses.alive()) alive.push_back(live.hypothesis);
  return alive;
}

std::map<std::string, Score> Localizer::scores_of(HypothesisId hypothesis) const {
  std::map<std::string, Score> scores;
  for (const Live& live : state_->hypotheses.alive())
    if (live.hypothesis.id == hypothesis)
      for (std::size_t k = 0; k < live.scores.size(); ++k) scores[state_->ensemble.scorers()[k].name] = live.scores[k];
  return scores;
}

const std::vector<SensorFinding>& Localizer::sensor_findings() const { return state_->sensors.findings(); }
const std::string& Localizer::why() const { return state_->status.belief().why; }
std::string Localizer::map_doubt() const { return state_->status.map_doubt(); }
const StageTimes& Localizer::last_times() const { return state_->times; }
const std::map<std::string, int>& Localizer::plugin_failures() const { return state_->failures.counts(); }

}  // namespace opal
