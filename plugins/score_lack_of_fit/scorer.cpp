#include "scorer.hpp"

#include <algorithm>

namespace {

const opal::LocalFeature* find(const opal::LocalMap& map, int id) {
  const auto& features = map.features();
  const auto it = std::lower_bound(features.begin(), features.end(), id,
                                   [](const opal::LocalFeature& f, int wanted) { return f.id < wanted; });
  return it != features.end() && it->id == id ? &*it : nullptr;
}

/// Projected distance for faces (both end points to the mapped line), Euclidean for the rest: eq. 3.12.
double error_m(const opal::Geometry& placed, const opal::Geometry& mapped) {
  const auto* a = std::get_if<opal::Segment>(&placed);
  const auto* b = std::get_if<opal::Segment>(&mapped);
  if (a && b) {
    const opal::Point normal = b->normal();
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

opal::Score LackOfFitScorer::score(const opal::Hypothesis& hypothesis, const opal::Observation& observation,
                                   const opal::MapView& map) const {
  double squares = 0, worst = 0;
  int matched = 0, unmatched = 0;
  const auto& all = hypothesis.associations;
  for (auto it = all.rbegin(); it != all.rend() && matched + unmatched < horizon_; ++it) {
    const opal::LocalFeature* local = find(observation.local_map, it->local_feature);
    if (!local) continue;
    if (it->map_feature < 0) {
      ++unmatched;
      continue;
    }
    const double error = error_m(transformed(hypothesis.T_map_local, local->feature.geometry),
                                 map.feature(it->map_feature).geometry);
    squares += error * error;
    worst = std::max(worst, error);
    ++matched;
  }
  const int n = std::max(1, matched + unmatched);
  const double fit = -squares / (sigma_m_ * sigma_m_) / n;
  const double clutter = unmatched * std::log(not_on_map_probability_) / n;
  opal::Score score{weight_ * (fit + clutter), {}, {{"fit", fit}, {"not_on_map", clutter}, {"worst_m", worst}}};
  if (veto_m_ > 0 && worst > veto_m_)
    score.veto = "an association is " + std::to_string(worst) + " m off, more than " + std::to_string(veto_m_);
  return score;
}
