#include "scorer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal::score_lack_of_fit {
namespace {

const LocalFeature* find(const LocalMap& map, LocalFeatureId id) {
  const auto& features = map.features();
  const auto it = std::ranges::lower_bound(features, id, {}, &LocalFeature::id);
  return it != features.end() && it->id == id ? &*it : nullptr;
}

/// Projected distance for faces (both end points to the mapped line), Euclidean for the rest: eq. 3.12.
double error_m(const Geometry& placed, const Geometry& mapped) {
  const auto* a = std::get_if<Segment>(&placed);
  const auto* b = std::get_if<Segment>(&mapped);
  if (a && b) {
    const Point normal = b->normal();
    return std::max(std::abs(normal.dot(a->begin - b->begin)), std::abs(normal.dot(a->end - b->begin)));
  }
  return (anchor_of(placed) - anchor_of(mapped)).norm();
}

}  // namespace

LackOfFitScorer::LackOfFitScorer(const nlohmann::json& options)
    : horizon_(options.at("horizon")),
      sigma_m_(options.at("sigma_m")),
      weight_(options.at("weight")),
      not_on_map_probability_(options.at("not_on_map_probability")),
      veto_m_(options.at("veto_m")) {}

/// The newest associations whose local feature is still known.
struct LackOfFitScorer::Fit {
  double squares = 0, worst_m = 0;
  Association worst;
  int matched = 0, unmatched = 0;
};

LackOfFitScorer::Fit LackOfFitScorer::fit_of(const Hypothesis& hypothesis, const Observation& observation,
                                             const MapView& map) const {
  Fit fit;
  const auto& all = hypothesis.associations;
  for (auto it = all.rbegin(); it != all.rend() && fit.matched + fit.unmatched < horizon_; ++it) {
    const LocalFeature* local = find(observation.local_map, it->local_feature);
    if (!local) continue;
    if (!it->map_feature.exists()) {
      ++fit.unmatched;
      continue;
    }
    const double error =
        error_m(transformed(hypothesis.T_map_local, local->feature.geometry), map.feature(it->map_feature).geometry);
    fit.squares += error * error;
    ++fit.matched;
    if (error <= fit.worst_m) continue;
    fit.worst_m = error;
    fit.worst = *it;
  }
  return fit;
}

Score LackOfFitScorer::score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
                             const ScorerMemory*) const {
  const Fit all = fit_of(hypothesis, observation, map);
  const double fit = -all.squares / (sigma_m_ * sigma_m_);
  const double matched = -all.matched * std::log(not_on_map_probability_);
  Score score{weight_ * (matched + fit),
              {},
              {{"matched", matched}, {"fit", fit}, {"not_on_map", double(all.unmatched)}, {"worst_m", all.worst_m}}};
  if (veto_m_ > 0 && all.worst_m > veto_m_)
    score.veto = fmt::format("an association is {:.2f} m off, more than {:.2f} m", all.worst_m, veto_m_);
  return score;
}

std::vector<Finding> LackOfFitScorer::explain(const Hypothesis& hypothesis, const Observation& observation,
                                              const MapView& map) const {
  const Fit fit = fit_of(hypothesis, observation, map);
  if (!fit.worst.map_feature.exists()) return {};
  const MapFeature& mapped = map.feature(fit.worst.map_feature);
  const MapObject& object = map.map().object(mapped.object);
  const LocalFeature* local = find(observation.local_map, fit.worst.local_feature);
  const Geometry placed = transformed(hypothesis.T_map_local, local->feature.geometry);
  return {{fmt::format("local feature {} is {:.2f} m off {} {}, more than any other",
                       to_string(fit.worst.local_feature), fit.worst_m, object.type, object.id),
           fit.worst.map_feature,
           {anchor_of(placed), anchor_of(mapped.geometry)}}};
}

}  // namespace opal::score_lack_of_fit
