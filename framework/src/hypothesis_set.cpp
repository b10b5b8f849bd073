#include "hypothesis_set.hpp"

#include <opal/registration.hpp>

#include <algorithm>

namespace opal {
namespace {

bool better(const Live& a, const Live& b) {
  return a.hypothesis.log_likelihood > b.hypothesis.log_likelihood;
}

void sort_best_first(std::vector<Live>& alive) { std::stable_sort(alive.begin(), alive.end(), better); }

bool ended(const Live& live) { return live.leaf < 0; }

bool knows(const Live& live, int local_feature) {
  return std::any_of(live.hypothesis.associations.begin(), live.hypothesis.associations.end(),
                     [&](const Association& a) { return a.local_feature == local_feature; });
}

const LocalFeature* find_local(const LocalMap& map, int id) {
  const auto& all = map.features();
  const auto it = std::lower_bound(all.begin(), all.end(), id,
                                   [](const LocalFeature& f, int wanted) { return f.id < wanted; });
  return it != all.end() && it->id == id ? &*it : nullptr;
}

}  // namespace

HypothesisSet::HypothesisSet(std::shared_ptr<const MapView> map, const Judge& judge,
                             const AssociationOptions& options, PruneReport report)
    : map_(std::move(map)), judge_(judge), options_(options), report_(std::move(report)) {}

void HypothesisSet::clear() {
  alive_.clear();
  tree_.clear();
}

void HypothesisSet::end(Live& live, const std::string& reason) {
  report_(live, reason);
  tree_.release(live.leaf);
  live.leaf = -1;
}

Pose2 HypothesisSet::search_alignment(const Pose2& predicted, std::span<const Point> coarse,
                                      const Eigen::Vector2d& window) const {
  constexpr double kStep_m = 0.1, kStep_rad = 0.03, kCostOfDistance = 0.02;
  const int steps = static_cast<int>(std::ceil(window.x() / kStep_m));
  const int turns = static_cast<int>(std::ceil(window.y() / kStep_rad));
  Pose2 best = predicted;
  double best_value = -1;
  for (int turn = -turns; turn <= turns; ++turn)
    for (int i = -steps; i <= steps; ++i)
      for (int j = -steps; j <= steps; ++j) {
        const Pose2 pose(predicted.x() + i * kStep_m, predicted.y() + j * kStep_m,
                         predicted.heading_rad() + turn * kStep_rad);
        const double far = std::hypot(i, j) * kStep_m / window.x() + std::abs(turn) * kStep_rad / window.y();
        const double value = mean_nearness(*map_, coarse, pose) - kCostOfDistance * far;
        if (value > best_value) {
          best_value = value;
          best = pose;
        }
      }
  return best;
}

void HypothesisSet::track(const Observation& observation, double novelty, std::span<const Point> coarse,
                          const Eigen::Vector2d& window) {
  const Pose2& T_local_base = observation.local_map.T_local_base();
  const RefinementOptions refinement;
  int rank = 0;
  for (Live& live : alive_) {
    Hypothesis& hypothesis = live.hypothesis;
    Pose2 T_map_base = hypothesis.T_map_local * T_local_base;
    if (!observation.points.empty()) {
      if (window.x() > 0 && rank++ < options_.track_search)
        T_map_base = search_alignment(T_map_base, coarse, window);
      if (!options_.register_by_associations)
        T_map_base =
            refine_on_map(*map_, observation.points, observation.laser_position, T_map_base, refinement);
    }
    hypothesis.T_map_local = T_map_base * T_local_base.inverse();
    Judge::Verdict verdict = judge_.judge(hypothesis, observation);
    live.scan_nat = verdict.nat;
    live.scores = std::move(verdict.scores);
    ++live.updates;
    hypothesis.log_likelihood =
        (1 - novelty * (1 - options_.memory)) * hypothesis.log_likelihood + novelty * verdict.nat;
    if (!verdict.veto.empty()) end(live, "veto by " + verdict.veto);
  }
  std::erase_if(alive_, ended);
  merge(T_local_base);
  prune();
}

std::vector<int> HypothesisSet::adopt(std::vector<Candidate> candidates, const Observation& observation) {
  const Pose2 T_base_local = observation.local_map.T_local_base().inverse();
  std::vector<int> born;
  for (Candidate& candidate : candidates) {
    Live live;
    live.hypothesis.T_map_local = candidate.T_map_base * T_base_local;
    Judge::Verdict verdict = judge_.judge(live.hypothesis, observation);
    if (!verdict.veto.empty()) continue;
    const auto same_place = [&](const Live& old) {
      const Pose2 T_map_base = old.hypothesis.T_map_local * T_base_local.inverse();
      return distance_m(T_map_base, candidate.T_map_base) < options_.merge_m + 0.1 &&
             angle_between_rad(T_map_base, candidate.T_map_base) < options_.merge_rad + 0.05;
    };
    const auto old = std::find_if(alive_.begin(), alive_.end(), same_place);
    if (old != alive_.end()) {
      if (verdict.nat > old->scan_nat + 0.3) {  // clearly better aligned: the old one moves over
        old->hypothesis.log_likelihood += verdict.nat - old->scan_nat;
        old->hypothesis.T_map_local = live.hypothesis.T_map_local;
        old->scan_nat = verdict.nat;
        old->scores = std::move(verdict.scores);
      }
      continue;
    }
    live.hypothesis.id = next_id_++;
    live.hypothesis.log_likelihood = options_.birth_nat + verdict.nat;
    live.hypothesis.associations = candidate.pairs;
    live.leaf = tree_.add(-1, std::move(candidate.pairs));
    live.scan_nat = verdict.nat;
    live.scores = std::move(verdict.scores);
    live.updates = 1;
    born.push_back(live.hypothesis.id);
    alive_.push_back(std::move(live));
  }
  sort_best_first(alive_);
  prune();
  return born;
}

std::vector<Association> HypothesisSet::choices_for(const Live& live, const LocalFeature& local) const {
  const Geometry placed = transformed(live.hypothesis.T_map_local, local.feature.geometry);
  std::vector<std::pair<double, int>> found;
  for (int number : map_->within(anchor_of(placed), options_.gate_m)) {
    const MapFeature& mapped = map_->feature(number);
    if (mapped.type != local.feature.type || kind_of(mapped.geometry) != kind_of(placed)) continue;
    const Mismatch off = mismatch(placed, mapped.geometry);
    if (off.position_m <= options_.gate_m && off.heading_rad <= options_.gate_rad)
      found.emplace_back(off.position_m + off.heading_rad, number);
  }
  std::sort(found.begin(), found.end());
  if (found.size() > static_cast<std::size_t>(options_.max_branches)) found.resize(options_.max_branches);
  std::vector<Association> choices;
  for (const auto& [cost, number] : found) choices.push_back({local.id, number});
  if (found.empty() || options_.branch_not_on_map) choices.push_back({local.id, -1});
  return choices;
}

bool HypothesisSet::register_anew(Live& live, const LocalMap& local_map) const {
  std::vector<GeometryPair> pairs;
  const auto& all = live.hypothesis.associations;
  for (auto it = all.rbegin(); it != all.rend() && int(pairs.size()) < options_.registration_horizon; ++it)
    if (const LocalFeature* local = find_local(local_map, it->local_feature); local && it->map_feature >= 0)
      pairs.push_back({local->feature.geometry, map_->feature(it->map_feature).geometry});
  const Registration registration = register_geometry(pairs);
  if (std::any_of(registration.errors_m.begin(), registration.errors_m.end(),
                  [&](double error) { return error > options_.outlier_m; }))
    return false;
  if (registration.fixed == 3) live.hypothesis.T_map_local = registration.T_map_local;
  return true;
}

void HypothesisSet::branch(const LocalFeature& feature, const LocalMap& local_map) {
  std::vector<Live> grown;
  for (Live& live : alive_) {
    if (knows(live, feature.id)) {
      grown.push_back(std::move(live));
      continue;
    }
    bool first = true;
    for (const Association& choice : choices_for(live, feature)) {
      Live child = live;
      child.hypothesis.associations.push_back(choice);
      child.consecutive_not_on_map = choice.map_feature < 0 ? live.consecutive_not_on_map + 1 : 0;
      if (options_.register_by_associations && choice.map_feature >= 0 && !register_anew(child, local_map))
        continue;
      child.leaf = tree_.add(live.leaf, {choice});
      if (!first) child.hypothesis.id = next_id_++;
      first = false;
      grown.push_back(std::move(child));
    }
    if (first)
      end(live, "local feature " + std::to_string(feature.id) + " fits nothing that is left to choose");
    else
      tree_.release(live.leaf);
  }
  alive_ = std::move(grown);
}

void HypothesisSet::grow(const std::vector<const LocalFeature*>& features, const LocalMap& local_map) {
  const bool single = options_.max_branches == 1 && !options_.branch_not_on_map;
  if (!single) {
    for (const LocalFeature* feature : features) branch(*feature, local_map);
    merge_similar();
    prune();
    return;
  }
  for (Live& live : alive_) {  // one choice per feature: the whole set is one node
    std::vector<Association> pairs;
    for (const LocalFeature* feature : features)
      if (!knows(live, feature->id)) pairs.push_back(choices_for(live, *feature).front());
    if (pairs.empty()) continue;
    auto& known = live.hypothesis.associations;
    known.insert(known.end(), pairs.begin(), pairs.end());
    const int leaf = tree_.add(live.leaf, std::move(pairs));
    tree_.release(live.leaf);
    live.leaf = leaf;
  }
}

void HypothesisSet::forget(const LocalMap& local_map) {
  for (Live& live : alive_)
    std::erase_if(live.hypothesis.associations, [&](const Association& pair) {
      const LocalFeature* local = find_local(local_map, pair.local_feature);
      if (!local) return true;
      if (pair.map_feature < 0) return false;
      const Geometry placed = transformed(live.hypothesis.T_map_local, local->feature.geometry);
      const Mismatch off = mismatch(placed, map_->feature(pair.map_feature).geometry);
      return off.position_m > options_.outlier_m || off.heading_rad > options_.outlier_rad;
    });
}

void HypothesisSet::merge(const Pose2& T_local_base) {
  sort_best_first(alive_);
  for (std::size_t a = 0; a < alive_.size(); ++a) {
    if (ended(alive_[a])) continue;
    for (std::size_t b = a + 1; b < alive_.size(); ++b) {
      if (ended(alive_[b])) continue;
      const Pose2 T_a = alive_[a].hypothesis.T_map_local * T_local_base;
      const Pose2 T_b = alive_[b].hypothesis.T_map_local * T_local_base;
      if (angle_between_rad(T_a, T_b) < options_.merge_rad && distance_m(T_a, T_b) < options_.merge_m)
        end(alive_[b], "same place as hypothesis " + std::to_string(alive_[a].hypothesis.id));
    }
  }
  std::erase_if(alive_, ended);
}

void HypothesisSet::merge_similar() {
  if (options_.similar_depth == 0) return;
  sort_best_first(alive_);
  const auto tail = [&](const Live& live) {
    std::vector<std::pair<int, int>> last;
    const auto& all = live.hypothesis.associations;
    for (auto it = all.rbegin(); it != all.rend() && int(last.size()) < options_.similar_depth; ++it)
      last.emplace_back(it->local_feature, it->map_feature);
    return last;
  };
  for (std::size_t a = 0; a < alive_.size(); ++a)
    for (std::size_t b = a + 1; b < alive_.size(); ++b) {
      if (ended(alive_[a]) || ended(alive_[b])) continue;
      const auto last = tail(alive_[a]);
      const bool any_clutter =
          std::any_of(last.begin(), last.end(), [](const auto& pair) { return pair.second < 0; });
      if (!any_clutter && last == tail(alive_[b]))
        end(alive_[b], "same newest associations as hypothesis " + std::to_string(alive_[a].hypothesis.id));
    }
  std::erase_if(alive_, ended);
}

void HypothesisSet::prune() {
  sort_best_first(alive_);
  if (alive_.empty()) return;
  const double best = alive_.front().hypothesis.log_likelihood;
  for (std::size_t k = 0; k < alive_.size(); ++k) {
    Live& live = alive_[k];
    if (live.hypothesis.log_likelihood < best - options_.prune_nat)
      end(live, "worse than the best by more than " + std::to_string(options_.prune_nat) + " nat");
    else if (options_.max_consecutive_not_on_map > 0 &&
             live.consecutive_not_on_map > options_.max_consecutive_not_on_map)
      end(live, "too many features in a row that are not on the map");
    else if (k >= static_cast<std::size_t>(options_.max_hypotheses))
      end(live, "beyond the number of hypotheses kept");
  }
  std::erase_if(alive_, ended);
}

}  // namespace opal
