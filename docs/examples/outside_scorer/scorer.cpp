#include "scorer.hpp"

#include <cmath>
#include <numbers>

LikelihoodFieldScorer::LikelihoodFieldScorer(const nlohmann::json& options)
    : weight_(options.at("weight")), sigma_m_(options.at("sigma_m")), hit_share_(options.at("hit_share")) {}

opal::Score LikelihoodFieldScorer::score(const opal::Hypothesis& hypothesis, const opal::Observation& observation,
                                         const opal::MapView& map, const opal::ScorerMemory*) const {
  if (observation.points() == 0) return {0, {}, {{"near", 0}}};
  const opal::Pose2 T_map_base = observation.T_map_base(hypothesis.T_map_local);
  // Densities of a return's distance from the nearest surface: about a surface, and anywhere in the field.
  const double peak_per_m = 2 / (sigma_m_ * std::sqrt(2 * std::numbers::pi));
  const double anywhere_per_m = 1 / opal::MapView::clearance_cap_m();
  double sum = 0;
  for (const opal::ObservedScan& scan : observation.scans)  // one a laser
    for (const opal::Point& point : scan.points) {
      const double off = map.clearance_m(T_map_base * point) / sigma_m_;
      sum += std::log(1 - hit_share_ + hit_share_ * std::exp(-0.5 * off * off) * peak_per_m / anywhere_per_m);
    }
  const double near = weight_ * sum / static_cast<double>(observation.points());
  return {near, {}, {{"near", near}}};
}
