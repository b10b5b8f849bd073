#include "localization/search/retrospective_verification.hpp"

#include "localization/alignment/registration.hpp"

#include <algorithm>
#include <utility>

namespace opal {
namespace {

/// Half of the beams tell nearly as much, at half the price.
template <class T>
std::vector<T> every_other(const std::vector<T>& all) {
  std::vector<T> half;
  for (std::size_t k = 0; k < all.size(); k += 2) half.push_back(all[k]);
  return half;
}

std::vector<ObservedScan> every_other_beam(const std::vector<ObservedScan>& scans) {
  std::vector<ObservedScan> half;
  for (const ObservedScan& scan : scans)
    half.push_back({.laser_position = scan.laser_position,
                    .points = every_other(scan.points),
                    .free_bearings_rad = every_other(scan.free_bearings_rad),
                    .range_max_m = scan.range_max_m,
                    .beams = every_other(scan.beams),
                    .evidence_cells = every_other(scan.evidence_cells)});
  return half;
}

}  // namespace

void RetrospectiveVerification::remember(const Observation& observation, KeyframeId keyframe, double tempering_weight,
                                         double best_nat, std::vector<PlaceComparison::Place> places) {
  if (options_.scans == 0 || observation.points() == 0) return;
  pending_ += tempering_weight;
  if (pending_ < 1 && !scans_.empty()) return;
  const double piece = std::min(pending_, 1.0);  // no scan is more than one whole piece of evidence
  scans_.push_front({observation.local_map.T_local_base(), every_other_beam(observation.scans), observation.features,
                     observation.feature_scans, piece, best_nat, keyframe, std::move(places)});
  pending_ -= piece;
  if (scans_.size() > static_cast<std::size_t>(options_.scans)) scans_.pop_back();
}

double RetrospectiveVerification::best_nat() const {
  double weight = 1, nat = 0;
  for (const PastScan& scan : scans_) {
    weight *= std::pow(evidence_memory_, scan.tempering_weight);
    nat += weight * scan.tempering_weight * scan.best_nat;
  }
  return nat;
}

RetrospectiveVerification::Verdict RetrospectiveVerification::verify(const Hypothesis& hypothesis,
                                                                     const LocalMap& local_map) const {
  RefinementOptions refinement;
  refinement.iterations = 2;
  const Pose2& T_local_now = local_map.T_local_base();
  const Pose2 T_now_local = T_local_now.inverse();
  Pose2 T_later_local = T_now_local, T_map_base = hypothesis.T_map_local * T_local_now;
  Hypothesis trial = hypothesis;
  Verdict verdict;
  const double most_behind_nat = lead_.kept_within_nat(options_.behind_nat, best_nat());
  double weight = 1, behind_nat = 0;
  std::optional<Verdict> kidnapped;  // the verdict if the robot was kidnapped
  for (const PastScan& scan : scans_) {
    if (kidnapping_ && !kidnapped && scan.keyframe <= kidnapping_->keyframe) {
      verdict.memories = trial.memories;
      kidnapped = if_kidnapped(verdict);
    }
    T_map_base = refine_on_map(*map_, scan.scans, T_map_base * (T_later_local * scan.T_local_base), refinement);
    T_later_local = scan.T_local_base.inverse();
    verdict.T_map_base.push_back(T_map_base);
    trial.T_map_local = T_map_base * T_now_local;  // scorers place the robot by the newest pose
    const Observation seen{
        .local_map = local_map, .scans = scan.scans, .features = scan.features, .feature_scans = scan.feature_scans};
    weight *= std::pow(evidence_memory_, scan.tempering_weight);
    ScorerEnsemble::Verdict judged = ensemble_.judge(trial, seen);
    const double nat = judged.nat;
    ensemble_.remember(trial, judged.scores, scan.tempering_weight);
    verdict.nat += weight * scan.tempering_weight * nat;
    behind_nat += weight * scan.tempering_weight * (scan.best_nat - nat);
    ++verdict.scans;
    verdict.hopeless = behind_nat > most_behind_nat;
    if (verdict.hopeless) break;
  }
  verdict.memories = trial.memories;
  if (kidnapping_ && !kidnapped && !verdict.hopeless) kidnapped = if_kidnapped(verdict);
  if (kidnapped && (verdict.hopeless || kidnapped->nat > verdict.nat)) return *kidnapped;
  return verdict;
}

RetrospectiveVerification::Verdict RetrospectiveVerification::if_kidnapped(const Verdict& since) const {
  return {since.nat + kidnapping_->nat,
          since.memories,
          kidnapping_->keyframe,
          kidnapping_->nat,
          since.scans,
          false,
          since.T_map_base};
}

void RetrospectiveVerification::place(HypothesisId hypothesis, const std::vector<Pose2>& T_map_base) {
  for (std::size_t k = 0; k < std::min(T_map_base.size(), scans_.size()); ++k)
    scans_[k].places.push_back({hypothesis, T_map_base[k]});
}

std::vector<PlaceComparison::Sight> RetrospectiveVerification::sights() const {
  std::vector<PlaceComparison::Sight> oldest_first;
  for (auto scan = scans_.rbegin(); scan != scans_.rend(); ++scan)
    oldest_first.push_back({scan->scans, scan->tempering_weight, scan->places});
  return oldest_first;
}

void RetrospectiveVerification::forget_until(KeyframeId keyframe) {
  std::erase_if(scans_, [&](const PastScan& scan) { return scan.keyframe <= keyframe; });
}

void RetrospectiveVerification::clear() {
  scans_.clear();
  pending_ = 0;
  kidnapping_.reset();
}

}  // namespace opal
