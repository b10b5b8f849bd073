#include "localization/tree/hypothesis_set.hpp"

#include "localization/alignment/registration.hpp"

#include <fmt/format.h>

#include <algorithm>

// How hypotheses say what local features are on the map: the growth of the association tree (Algorithm 2, Hendrikx
// 2023).

namespace opal {
namespace {

void count(const Association& choice, Live& live) {
  const bool not_on_map = !choice.map_feature.exists();
  live.not_on_map += not_on_map;
  live.consecutive_not_on_map = not_on_map ? live.consecutive_not_on_map + 1 : 0;
}

bool knows(const Live& live, LocalFeatureId local_feature) {
  return std::any_of(live.hypothesis.associations.begin(), live.hypothesis.associations.end(),
                     [&](const Association& a) { return a.local_feature == local_feature; });
}

const LocalFeature* find_local(const LocalMap& map, LocalFeatureId id) {
  const auto& all = map.features();
  const auto it = std::ranges::lower_bound(all, id, {}, &LocalFeature::id);
  return it != all.end() && it->id == id ? &*it : nullptr;
}

std::string outlier_words(double off_m, double most_m) {
  return fmt::format("an association would be {:.2f} m off, more than {:.2f} m", off_m, most_m);
}

}  // namespace

std::vector<Association> HypothesisSet::choices_for(const Live& live, const LocalFeature& local) const {
  const Geometry placed = transformed(live.hypothesis.T_map_local, local.feature.geometry);
  std::vector<std::pair<double, MapFeatureNumber>> found;
  for (MapFeatureNumber number : map_->within(anchor_of(placed), growth_.gate_m)) {
    const MapFeature& mapped = map_->feature(number);
    if (mapped.type != local.feature.type || kind_of(mapped.geometry) != kind_of(placed)) continue;
    const Mismatch off = mismatch(placed, mapped.geometry);
    if (off.position_m <= growth_.gate_m && off.heading_rad <= growth_.gate_rad)
      found.emplace_back(off.position_m + off.heading_rad, number);
  }
  std::sort(found.begin(), found.end());
  if (found.size() > static_cast<std::size_t>(growth_.max_branches)) found.resize(growth_.max_branches);
  std::vector<Association> choices;
  for (const auto& [cost, number] : found) choices.push_back({local.id, number});
  if (found.empty() || growth_.branch_not_on_map) choices.push_back({local.id, {}});
  return choices;
}

std::optional<double> HypothesisSet::register_anew(Live& live, const LocalMap& local_map) const {
  std::vector<GeometryPair> pairs;
  const auto& all = live.hypothesis.associations;
  for (auto it = all.rbegin(); it != all.rend() && int(pairs.size()) < growth_.registration_horizon; ++it)
    if (const LocalFeature* local = find_local(local_map, it->local_feature); local && it->map_feature.exists())
      pairs.push_back({local->feature.geometry, map_->feature(it->map_feature).geometry});
  const Registration registration = register_geometry(pairs);
  const auto worst = std::max_element(registration.errors_m.begin(), registration.errors_m.end());
  if (worst != registration.errors_m.end() && *worst > growth_.outlier_m) return *worst;
  if (registration.fixed == 3) live.hypothesis.T_map_local = registration.T_map_local;
  return std::nullopt;
}

bool HypothesisSet::grow_child(const Live& parent, const Association& choice, Identity identity,
                               const LocalMap& local_map, Live& child) {
  child = parent;
  child.hypothesis.associations.push_back(choice);
  child.not_on_map = parent.not_on_map;
  child.consecutive_not_on_map = parent.consecutive_not_on_map;
  count(choice, child);
  if (growth_.register_by_associations && choice.map_feature.exists())
    if (const auto off_m = register_anew(child, local_map)) {
      listener_.branch_rejected(parent, choice, outlier_words(*off_m, growth_.outlier_m));
      return false;
    }
  child.leaf = tree_.add(parent.leaf, {choice});
  if (identity == Identity::of_parent) {
    listener_.associated(child, std::span(&choice, 1));
  } else {
    child.hypothesis.id = new_id();
    listener_.spawned(child, {Origin::branch, {}, parent.hypothesis.id});
  }
  return true;
}

void HypothesisSet::branch(const LocalFeature& feature, const LocalMap& local_map) {
  std::vector<Live> grown;
  for (Live& live : alive_) {
    if (knows(live, feature.id)) {
      grown.push_back(std::move(live));
      continue;
    }
    const std::size_t before = grown.size();
    Live child;
    for (const Association& choice : choices_for(live, feature)) {
      const Identity identity = grown.size() == before ? Identity::of_parent : Identity::own;
      if (grow_child(live, choice, identity, local_map, child)) grown.push_back(std::move(child));
    }
    if (grown.size() == before)
      end(live, "local feature " + to_string(feature.id) + " fits nothing that is left to choose");
    else
      tree_.release(live.leaf);
  }
  alive_ = std::move(grown);
}

std::vector<const LocalFeature*> HypothesisSet::rarest_first(std::vector<const LocalFeature*> features) const {
  std::vector<std::pair<std::size_t, const LocalFeature*>> by_count;
  for (const LocalFeature* feature : features) by_count.emplace_back(index_.expected(feature->feature), feature);
  std::stable_sort(by_count.begin(), by_count.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t k = 0; k < features.size(); ++k) features[k] = by_count[k].second;
  return features;
}

void HypothesisSet::grow(const std::vector<const LocalFeature*>& features, const LocalMap& local_map) {
  const bool single = growth_.max_branches == 1 && !growth_.branch_not_on_map;
  if (!single) {
    for (const LocalFeature* feature : rarest_first(features)) {
      branch(*feature, local_map);
      merge_similar();
      prune_surplus();  // a spawned has much to say at once: its branches would double with every feature
    }
    prune();
    return;
  }
  for (Live& live : alive_) {  // one choice per feature: the whole set is one node
    std::vector<Association> pairs;
    for (const LocalFeature* feature : features)
      if (!knows(live, feature->id)) pairs.push_back(choices_for(live, *feature).front());
    if (pairs.empty()) continue;
    for (const Association& choice : pairs) count(choice, live);
    auto& known = live.hypothesis.associations;
    known.insert(known.end(), pairs.begin(), pairs.end());
    listener_.associated(live, pairs);
    const NodeId leaf = tree_.add(live.leaf, std::move(pairs));
    tree_.release(live.leaf);
    live.leaf = leaf;
  }
}

void HypothesisSet::forget(const LocalMap& local_map) {
  std::vector<LocalFeatureId> unknown, misfits;
  for (Live& live : alive_) {
    unknown.clear();
    misfits.clear();
    std::erase_if(live.hypothesis.associations, [&](const Association& pair) {
      const LocalFeature* local = find_local(local_map, pair.local_feature);
      if (!local) {
        unknown.push_back(pair.local_feature);
        return true;
      }
      if (!pair.map_feature.exists()) return false;
      const Geometry placed = transformed(live.hypothesis.T_map_local, local->feature.geometry);
      const Mismatch off = mismatch(placed, map_->feature(pair.map_feature).geometry);
      if (off.position_m <= growth_.outlier_m && off.heading_rad <= growth_.outlier_rad) return false;
      misfits.push_back(pair.local_feature);
      return true;
    });
    if (!unknown.empty()) listener_.dissociated(live, unknown, "the local map has forgotten it");
    if (!misfits.empty()) listener_.dissociated(live, misfits, "it no longer fits");
    if (!unknown.empty() || !misfits.empty()) tree_.trim(live.leaf, live.hypothesis.associations);
  }
}

}  // namespace opal
