#include "localization/search/hindsight.hpp"

#include "localization/alignment/registration.hpp"

namespace opal {
namespace {

/// Half of the beams tell nearly as much, at half the price.
template <class T>
std::vector<T> every_other(const std::vector<T>& all) {
  std::vector<T> half;
  for (std::size_t k = 0; k < all.size(); k += 2) half.push_back(all[k]);
  return half;
}

}  // namespace

void Hindsight::remember(const Observation& observation, int keyframe, double novelty, double best_nat) {
  pending_ += novelty;
  if (options_.hindsight_scans == 0 || observation.points.empty() || (pending_ < 1 && !scans_.empty())) return;
  scans_.push_front({observation.local_map.T_local_base(), every_other(observation.points),
                     every_other(observation.patches), every_other(observation.free_bearings_rad),
                     observation.range_max_m, observation.laser_position, observation.features, pending_, best_nat, keyframe});
  pending_ = 0;
  if (scans_.size() > static_cast<std::size_t>(options_.hindsight_scans)) scans_.pop_back();
}

Hindsight::Verdict Hindsight::look_back(const Hypothesis& hypothesis, const LocalMap& local_map) const {
  RefinementOptions refinement;
  refinement.iterations = 2;
  const Pose2& T_local_now = local_map.T_local_base();
  const Pose2 T_now_local = T_local_now.inverse();
  Pose2 T_later_local = T_now_local, T_map_base = hypothesis.T_map_local * T_local_now;
  Hypothesis trial = hypothesis;
  Verdict verdict;
  double weight = 1, behind_nat = 0;
  std::optional<Verdict> carried;  // the verdict if the robot was carried away
  for (const PastScan& scan : scans_) {
    if (carried_away_ && !carried && scan.keyframe <= carried_away_->keyframe) {
      verdict.encounters = trial.encounters;
      carried = if_carried(verdict);
    }
    T_map_base = refine_on_map(*map_, scan.points, scan.laser_position,
                               T_map_base * (T_later_local * scan.T_local_base), refinement);
    T_later_local = scan.T_local_base.inverse();
    trial.T_map_local = T_map_base * T_now_local;  // scorers place the robot by the newest pose
    const Observation seen{local_map,         scan.points,         scan.free_bearings_rad, scan.range_max_m,
                           scan.laser_position, scan.features, {}, scan.patches};
    weight *= std::pow(options_.memory, scan.novelty);
    Judge::Verdict judged = judge_.judge(trial, seen);
    const double nat = judged.nat;
    trial.encounters.take(judged.encounters, scan.novelty, 1);
    verdict.nat += weight * scan.novelty * nat;
    behind_nat += weight * scan.novelty * (scan.best_nat - nat);
    ++verdict.scans;
    verdict.hopeless = behind_nat > options_.hindsight_behind_nat;
    if (verdict.hopeless) break;
  }
  verdict.encounters = trial.encounters;
  if (carried_away_ && !carried && !verdict.hopeless) carried = if_carried(verdict);
  if (carried && (verdict.hopeless || carried->nat > verdict.nat)) return *carried;
  return verdict;
}

Hindsight::Verdict Hindsight::if_carried(const Verdict& since) const {
  return {since.nat + carried_away_->nat, since.encounters, carried_away_->keyframe, carried_away_->nat, since.scans, false};
}

void Hindsight::forget_until(int keyframe) {
  std::erase_if(scans_, [&](const PastScan& scan) { return scan.keyframe <= keyframe; });
}

void Hindsight::clear() {
  scans_.clear();
  pending_ = 0;
  carried_away_.reset();
}

}  // namespace opal
