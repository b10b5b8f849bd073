#include "scorer.hpp"

#include <algorithm>

namespace opal::score_evidence {
namespace {

// Across its ends a face of a scan is known to about a range's noise [m]: the shorter it is, the less its heading says.
constexpr double kEndSigma_m = 0.02;
// Faces of the scan are not shorter than this [m] where a number is divided by their length.
constexpr double kLeastLength_m = 1e-3;
// The mapped face must lie beside this share of the observed one: less is the next face of the same wall.
constexpr double kLeastShare = 0.4;
// Beyond the gate features are looked up so far [m]: a column is found by its outline, and compared by its middle.
constexpr double kLookupMargin_m = 1.0;
// A face of this length [m] counts as a whole feature, a shorter one by its length: small clutter is often flat, too.
constexpr double kWholeLength_m = 1.5;
// A scan of fewer features counts as one of this many: a lone match is no proof.
constexpr double kFewestFeatures = 3;

}  // namespace

struct EvidenceScorer::Match {
  bool found = false;
  double log_ratio = 0;
  double share = 1;  ///< how much of the observed feature the mapped one covers
};

EvidenceScorer::EvidenceScorer(const nlohmann::json& options)
    : weight_(options.at("weight")),
      sigma_m_(options.at("sigma_m")),
      sigma_rad_(options.at("sigma_rad")),
      clutter_per_m_rad_(options.at("clutter_per_m_rad")),
      clutter_per_m2_(options.at("clutter_per_m2")),
      gate_chi2_(options.at("gate_chi2")),
      unmatched_nat_(options.at("unmatched_nat")) {}

EvidenceScorer::Match EvidenceScorer::match_face(const Segment& observed, const Point& eye, const MapView& map) const {
  const Point middle = observed.midpoint();
  const MapFeatureNumber number = map.nearest_facing(middle, middle - eye);
  const auto* face = number.exists() ? std::get_if<Segment>(&map.feature(number).geometry) : nullptr;
  if (!face) return {};
  const double length = std::max(observed.length_m(), kLeastLength_m);
  const double angle = wrap_angle(observed.heading_rad() - face->heading_rad());
  const double angle_sigma = sigma_rad_ + kEndSigma_m / length;
  const double offset = face->normal().dot(middle - face->begin);
  const double chi2 = std::pow(angle / angle_sigma, 2) + std::pow(offset / sigma_m_, 2);
  const double u = face->direction().dot(observed.begin - face->begin);
  const double v = face->direction().dot(observed.end - face->begin);
  const double covered = std::min(face->length_m(), std::max(u, v)) - std::max(0.0, std::min(u, v));
  const double share = std::clamp(covered / length, 0.0, 1.0);
  if (chi2 > gate_chi2_ || share < kLeastShare) return {};
  const double density = 1 / (2 * std::numbers::pi * angle_sigma * sigma_m_);
  return {true, -0.5 * chi2 + std::log(density / clutter_per_m_rad_), share};
}

EvidenceScorer::Match EvidenceScorer::match_point(const Feature& observed, const MapView& map) const {
  const Point place = anchor_of(observed.geometry);
  const double gate_m = std::sqrt(gate_chi2_) * sigma_m_;
  Match best;
  for (MapFeatureNumber number : map.within(place, gate_m + kLookupMargin_m)) {
    const MapFeature& mapped = map.feature(number);
    if (mapped.type != observed.type || kind_of(mapped.geometry) != kind_of(observed.geometry)) continue;
    const double distance = (anchor_of(mapped.geometry) - place).norm();
    const double chi2 = std::pow(distance / sigma_m_, 2);
    if (chi2 > gate_chi2_) continue;
    const double density = 1 / (2 * std::numbers::pi * sigma_m_ * sigma_m_);
    const double log_ratio = -0.5 * chi2 + std::log(density / clutter_per_m2_);
    if (!best.found || log_ratio > best.log_ratio) best = {true, log_ratio, 1};
  }
  return best;
}

EvidenceScorer::Match EvidenceScorer::best_match(const Feature& observed, const Point& eye, const MapView& map) const {
  const auto* segment = std::get_if<Segment>(&observed.geometry);
  return segment ? match_face(*segment, eye, map) : match_point(observed, map);
}

bool EvidenceScorer::matches(const Feature& observed, const Point& eye, const MapView& map) const {
  return best_match(observed, eye, map).found;
}

Score EvidenceScorer::score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
                            const ScorerMemory*) const {
  const Pose2 T_map_base = observation.T_map_base(hypothesis.T_map_local);
  double matched = 0, missed = 0;
  int matches = 0;
  for (std::size_t k = 0; k < observation.features.size(); ++k) {
    const Feature placed = transformed(T_map_base, observation.features[k]);
    const Point eye = T_map_base * observation.viewpoint_of(k);
    const auto* segment = std::get_if<Segment>(&placed.geometry);
    const double size = segment ? std::min(1.0, segment->length_m() / kWholeLength_m) : 1.0;
    if (const Match match = best_match(placed, eye, map); match.found) {
      matched += match.log_ratio * match.share * size;
      ++matches;
    } else {
      missed += unmatched_nat_ * size;
    }
  }
  const double n = std::max(kFewestFeatures, static_cast<double>(observation.features.size()));
  return {
      weight_ * (matched + missed) / n, {}, {{"matches", double(matches)}, {"matched", matched}, {"missed", missed}}};
}

}  // namespace opal::score_evidence
