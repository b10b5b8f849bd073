#include "localization/events/run_journal.hpp"

#include "localization/observation/observation.hpp"

#include <opal/sensing/free_space.hpp>
#include "common/json/event_json.hpp"
#include "localization/alignment/registration.hpp"

#include <algorithm>

namespace opal {
namespace {

constexpr double kScanSpacing_m = 0.03;
constexpr std::size_t kMostScanPoints = 400;

/// A local feature is written again when it has moved or turned by this.
constexpr double kMoved_m = 0.01, kTurned_rad = 0.005;

bool has_moved(const Geometry& now, const Geometry& before) {
  const auto* a = std::get_if<Segment>(&now);
  const auto* b = std::get_if<Segment>(&before);
  if (a && b) return (a->begin - b->begin).norm() > kMoved_m || (a->end - b->end).norm() > kMoved_m;
  const Mismatch off = mismatch(now, before);
  return off.position_m > kMoved_m || off.heading_rad > kTurned_rad;
}

std::size_t returns_in(const Sample& sample) {
  std::size_t returns = 0;
  for (const LaserView& view : sample.views) returns += view.scan.points.size();
  return returns;
}

/// One outline; of several lasers one after the other, each closed: filled, they are what all beams passed through.
std::vector<Point> free_space_of(const Sample& sample) {
  if (sample.views.size() == 1) return free_space_outline(sample.views.front().scan, sample.views.front().T_base_laser);
  std::vector<Point> outlines;
  for (const LaserView& view : sample.views) {
    const std::vector<Point> outline = free_space_outline(view.scan, view.T_base_laser);
    outlines.insert(outlines.end(), outline.begin(), outline.end());
    if (!outline.empty()) outlines.push_back(outline.front());
  }
  return outlines;
}

double milliseconds(double seconds) { return std::round(1e6 * seconds) / 1e3; }

}  // namespace

RunJournal::Json RunJournal::event(const char* kind) const {
  return {{"event", kind}, {"stamp_s", stamp_s_}, {"keyframe", keyframe_}};
}

Pose2 RunJournal::T_map_base(const Live& live) const { return observation_->T_map_base(live.hypothesis.T_map_local); }

void RunJournal::reset() {
  written_.clear();
  reported_.reset();
  sensor_ = Json::array();
}

// ---------------------------------------------------------------------------------------------- what is seen

void RunJournal::keyframe(const Sample& sample, KeyframeId keyframe, const Observation& observation) {
  stamp_s_ = sample.stamp_s;
  keyframe_ = keyframe;
  observation_ = &observation;
  rejected_ = Json::array();
  if (!listening()) return;
  const LocalMap& local_map = observation.local_map;
  auto e = event("keyframe");
  e["T_local_base"] = pose_json(local_map.T_local_base());
  e["points"] = returns_in(sample);
  e["features"] = observation.features.size();
  e["local_features"] = local_map.features().size();
  e["scan_match"] = local_map.last_match().converged;
  e["scan"] = points_json(thinned_points(sample, kScanSpacing_m, kMostScanPoints));
  e["free_space"] = points_json(free_space_of(sample));
  events_.write(e);
  local_features(local_map);
}

void RunJournal::local_features(const LocalMap& local_map) {
  auto changed = Json::array(), gone = Json::array();
  std::vector<std::pair<LocalFeatureId, std::string>> stable;
  for (auto& [id, written] : written_) written.alive = false;
  for (const LocalFeature& local : local_map.features()) {
    const auto [it, fresh] = written_.try_emplace(local.id);
    Written& written = it->second;
    written.alive = true;
    if (local.stable && !written.stable) stable.emplace_back(local.id, local.feature.type);
    // Every detection adds a measurement: the count alone is written when it has grown by half.
    const bool same = !fresh && written.stable == local.stable &&
                      2 * local.measurements.size() < 3 * written.measurements &&
                      !has_moved(local.feature.geometry, written.geometry);
    if (same) continue;
    written = {local.feature.geometry, local.stable, local.measurements.size(), true};
    Json json{{"id", local.id},
              {"type", local.feature.type},
              {"stable", local.stable},
              {"measurements", local.measurements.size()}};
    add_geometry(json, local.feature.geometry);
    changed.push_back(std::move(json));
  }
  std::vector<LocalFeatureId> forgotten;
  for (const auto& [id, written] : written_)
    if (!written.alive) forgotten.push_back(id);
  std::sort(forgotten.begin(), forgotten.end());
  for (LocalFeatureId id : forgotten) {
    gone.push_back(id);
    written_.erase(id);
  }
  if (!changed.empty() || !gone.empty()) {
    auto e = event("local_features");
    e["changed"] = std::move(changed);
    e["gone"] = std::move(gone);
    events_.write(e);
  }
  for (const auto& [id, type] : stable) {
    auto s = event("stable");
    s["local_feature"] = id;
    s["type"] = type;
    events_.write(s);
  }
}

// ---------------------------------------------------------------------------------------------- hypotheses

RunJournal::Json RunJournal::pairs_json(std::span<const Association> pairs) const {
  auto json = Json::array();
  for (const Association& pair : pairs)
    json.push_back(
        {pair.local_feature, pair.map_feature.exists() ? Json(map_->feature(pair.map_feature).id) : Json(nullptr)});
  return json;
}

RunJournal::Json RunJournal::scores_json(const Live& live) const {
  auto json = Json::object();
  for (std::size_t k = 0; k < live.scores.size(); ++k)
    for (const Score::Term& term : live.scores[k].breakdown) json[ensemble_.scorers()[k].name][term.name] = term.value;
  return json;
}

RunJournal::Json RunJournal::findings_json(const Live& live) const {
  auto json = Json::array();
  for (const auto& [scorer, finding] : ensemble_.explain(live.hypothesis, *observation_)) {
    Json one{{"scorer", scorer}, {"words", finding.words}};
    if (finding.map_feature.exists()) one["map_feature"] = map_->feature(finding.map_feature).id;
    if (!finding.line.empty()) one["line"] = points_json(finding.line);
    json.push_back(std::move(one));
  }
  return json;
}

void RunJournal::spawned(const Live& live, const Beginning& beginning) {
  if (!listening()) return;
  auto e = event("spawned");
  e["hypothesis"] = live.hypothesis.id;
  if (beginning.parent.exists()) e["parent"] = beginning.parent;
  e["origin"] = name_of(beginning.origin);
  if (beginning.pattern.exists()) e["template"] = search_.pattern_name(beginning.pattern);
  e["T_map_base"] = pose_json(T_map_base(live));
  e["log_likelihood"] = live.hypothesis.log_likelihood;
  e["pairs"] = pairs_json(live.hypothesis.associations);
  events_.write(e);
}

void RunJournal::ended(const Live& live, const Ending& ending) {
  if (!listening()) return;
  auto e = event("pruned");
  e["hypothesis"] = live.hypothesis.id;
  e["reason"] = ending.reason;
  const bool merged = ending.merged_into.exists();
  if (merged) e["merged_into"] = ending.merged_into;
  e["T_map_base"] = pose_json(T_map_base(live));
  e["log_likelihood"] = live.hypothesis.log_likelihood;
  e["scan_nat"] = live.scan_nat;
  e["scores"] = scores_json(live);
  e["findings"] = merged ? Json::array() : findings_json(live);
  events_.write(e);
}

void RunJournal::associated(const Live& live, std::span<const Association> pairs) {
  if (!listening()) return;
  auto e = event("associated");
  e["hypothesis"] = live.hypothesis.id;
  e["pairs"] = pairs_json(pairs);
  events_.write(e);
}

void RunJournal::dissociated(const Live& live, const std::vector<LocalFeatureId>& local_features,
                             const std::string& reason) {
  if (!listening()) return;
  auto e = event("dissociated");
  e["hypothesis"] = live.hypothesis.id;
  e["local_features"] = local_features;
  e["reason"] = reason;
  events_.write(e);
}

void RunJournal::branch_rejected(const Live& parent, const Association& pair, const std::string& reason) {
  if (!listening()) return;
  auto e = event("rejected");
  e["hypothesis"] = parent.hypothesis.id;
  e["pairs"] = pairs_json(std::span(&pair, 1));
  e["reason"] = reason;
  events_.write(e);
}

void RunJournal::candidate_rejected(const VerifiedCandidate& verified, const std::string& reason) {
  if (!listening()) return;
  const Candidate& candidate = verified.candidate;
  Json json{{"origin", name_of(candidate.origin)}};
  if (candidate.pattern.exists()) json["template"] = search_.pattern_name(candidate.pattern);
  json["T_map_base"] = pose_json(candidate.T_map_base);
  json["pairs"] = pairs_json(candidate.pairs);
  json["nat"] = verified.nat;
  json["reason"] = reason;
  rejected_.push_back(std::move(json));
}

void RunJournal::searched(std::span<const CandidateGenerator::LookedUp> looked_up, std::size_t proposed) {
  if (!listening()) return;
  auto e = event("searched");
  e["patterns"] = Json::array();
  for (const CandidateGenerator::LookedUp& each : looked_up)
    e["patterns"].push_back({{"template", search_.pattern_name(each.pattern)},
                             {"local_features", each.local_features},
                             {"candidates", each.expected}});
  e["proposed"] = proposed;
  e["rejected"] = std::exchange(rejected_, Json::array());
  events_.write(e);
}

// ---------------------------------------------------------------------------------------------- the answer

RunJournal::Json RunJournal::hypothesis_json(const Live& live, double probability) const {
  return {{"hypothesis", live.hypothesis.id},
          {"T_map_base", pose_json(T_map_base(live))},
          {"log_likelihood", live.hypothesis.log_likelihood},
          {"scan_nat", live.scan_nat},
          {"probability", probability},
          {"scores", scores_json(live)}};
}

void RunJournal::estimate(const PoseEstimate& estimate, const std::vector<Live>& alive,
                          const StatusEstimator::Belief& belief) {
  if (!listening()) return;
  auto e = event("estimate");
  e["status"] = name_of(estimate.status);
  e["probability"] = estimate.probability;
  e["none"] = belief.none;
  e["why"] = belief.why;
  if (estimate.has_pose) {
    e["hypothesis"] = estimate.best;
    e["T_map_base"] = pose_json(estimate.T_map_base);
    if (const PlaceInBuilding& place = estimate.place; !place.storey.empty())
      e["place"] = {
          {"building", place.building}, {"storey", place.storey}, {"T_storey_base", pose_json(place.T_storey_base)}};
  }
  auto rows = Json::array();
  for (std::size_t k = 0; k < alive.size(); ++k) rows.push_back(hypothesis_json(alive[k], belief.hypotheses[k]));
  e["hypotheses"] = std::move(rows);
  e["findings"] = alive.empty() ? Json::array() : findings_json(alive.front());
  if (!sensor_.empty()) e["sensor"] = sensor_;
  events_.write(e);
  status_change(estimate);
}

void RunJournal::sensor(const std::vector<SensorFinding>& findings) {
  sensor_ = Json::array();
  for (const SensorFinding& finding : findings)
    if (finding.verdict != SensorFinding::Verdict::fine) sensor_.push_back(finding.words);
}

void RunJournal::status_change(const PoseEstimate& estimate) {
  if (reported_ == estimate.status) return;
  reported_ = estimate.status;
  auto e = event("status");
  e["status"] = name_of(estimate.status);
  e["probability"] = estimate.probability;
  e["hypothesis"] = estimate.best;
  events_.write(e);
}

void RunJournal::cost(const StageTimes& times, double total_s) {
  observation_ = nullptr;
  if (!listening()) return;
  auto e = event("cost");
  e["cpu_ms"] = {{"sensor", milliseconds(times.sensor_s)},         {"detect", milliseconds(times.detect_s)},
                 {"local_map", milliseconds(times.local_map_s)},   {"track", milliseconds(times.track_s)},
                 {"generate", milliseconds(times.generate_s)},     {"search", milliseconds(times.search_s)},
                 {"retrospect", milliseconds(times.retrospect_s)}, {"grow", milliseconds(times.grow_s)},
                 {"status", milliseconds(times.status_s)},         {"total", milliseconds(total_s)}};
  events_.write(e);
}

}  // namespace opal
