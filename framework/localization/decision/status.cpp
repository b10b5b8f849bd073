#include "localization/decision/status.hpp"

#include "common/covariance.hpp"
#include "localization/decision/same_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace opal {
namespace {

// A place with less is told only if its evidence comes near that of the best one: a large building has many such.
constexpr double kAlternativeProbability = 0.01;
// Share of the mean score that is kept at each scan: the newest five or so tell whether the robot is lost, and one
// scan behind people does not.
constexpr double kScanMemory = 0.8;

Status unproven(const PoseEstimate& estimate) {
  return estimate.alternatives.empty() ? Status::searching : Status::ambiguous;
}

/// To the digits that are printed: what is not above a limit must not look as if it were.
double rounded_down(double probability) { return std::floor(probability * 1000) / 1000; }

constexpr double kSigmas = 3;  // an error within so many standard deviations is to be expected

}  // namespace

const char* name_of(Status status) {
  switch (status) {
    case Status::searching: return "searching";
    case Status::ambiguous: return "ambiguous";
    case Status::localized: return "localized";
    case Status::lost: return "lost";
  }
  return "";
}

void StatusEstimator::reset() {
  last_ = {};
  belief_ = {};
  held_ = {};
  unbroken_ = std::numeric_limits<double>::infinity();
  none_nat_ = 0;
  was_localized_ = false;
  mean_scan_nat_ = 0;
  contradiction_.clear();
  agreement_.clear();
  drive_agreement_.clear();
  map_doubt_.clear();
  lead_ = {};
}

void StatusEstimator::believe(const std::vector<Live>& alive) {
  double top = none_nat_;
  for (const Live& live : alive) top = std::max(top, live.hypothesis.log_likelihood);
  double total = std::exp(none_nat_ - top);
  for (const Live& live : alive) total += std::exp(live.hypothesis.log_likelihood - top);
  belief_.none = std::exp(none_nat_ - top) / total;
  belief_.hypotheses.clear();
  for (const Live& live : alive) belief_.hypotheses.push_back(std::exp(live.hypothesis.log_likelihood - top) / total);
}

void StatusEstimator::weigh(const std::vector<Live>& alive, const Pose2& T_local_base, PoseEstimate& estimate) {
  const double best_nat = alive.front().hypothesis.log_likelihood;
  const double own_nat = best_nat - alive.front().ridden_nat;  // the rest says nothing between storeys
  lead_ = {std::numeric_limits<double>::infinity(), own_nat};
  for (std::size_t k = 0; k < alive.size(); ++k) {
    const Live& live = alive[k];
    const Pose2 pose = live.hypothesis.T_map_local * T_local_base;
    const double probability = belief_.hypotheses[k];
    if (kSamePlace.holds(pose, estimate.T_map_base)) {
      estimate.probability += probability;
      continue;
    }
    const double behind_nat = best_nat - live.hypothesis.log_likelihood;
    lead_.nat = std::min(lead_.nat, behind_nat);
    const auto alternative = std::find_if(estimate.alternatives.begin(), estimate.alternatives.end(),
                                          [&](const auto& r) { return kSamePlace.holds(r.T_map_base, pose); });
    if (alternative != estimate.alternatives.end())
      alternative->probability += probability;
    else if (probability > kAlternativeProbability || behind_nat < lead_asked_nat())
      estimate.alternatives.push_back({live.hypothesis.id, pose, probability});
  }
  std::stable_sort(estimate.alternatives.begin(), estimate.alternatives.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
}

double StatusEstimator::weight_asked(double unmapped_walls_m) const {
  const double beyond_m = std::max(0.0, unmapped_walls_m - options_.localized_unmapped_m);
  const double disagreed = std::max(0.0, options_.localized_agreement - agreement_.share());
  const double asked = options_.localized_weight + options_.localized_weight_per_m * beyond_m +
                       options_.localized_weight_per_share * disagreed;
  return std::max(options_.localized_weight, std::min(asked, options_.localized_most_weight));
}

void StatusEstimator::gather(const Live& best, const PoseEstimate& estimate, const Circumstances& now, bool same) {
  const bool probable = estimate.probability > options_.localized_probability, leads = lead_.nat >= lead_asked_nat();
  if (same && probable && leads)
    held_ = {held_.weight + now.tempering_weight, held_.nat + now.tempering_weight * best.scan_nat};
  else
    held_ = {};
  unbroken_ = now.is_broken ? 0 : unbroken_ + now.tempering_weight;
  if (!same) agreement_.clear();
  agreement_.add(now.agreement, now.tempering_weight);
  if (contradiction_.empty()) drive_agreement_.add(now.agreement, now.tempering_weight);
  mean_scan_nat_ = same ? kScanMemory * mean_scan_nat_ + (1 - kScanMemory) * best.scan_nat : best.scan_nat;
}

StatusEstimator::Judgement StatusEstimator::judge(const Live& best, const Pose2& T_local_base,
                                                  const PoseEstimate& estimate, const Circumstances& now) {
  const bool same = last_.has_pose && kSamePlace.holds(T_map_local_ * T_local_base, estimate.T_map_base);
  gather(best, estimate, now, same);
  if (!contradiction_.empty()) {
    if (evidence_ == Evidence::spoilt)
      held_ = {};
    else
      unbroken_ = 0;
    return {while_contradicted(estimate), contradiction_};
  }
  if (was_localized_ && mean_scan_nat_ < options_.lost_scan_nat)
    return {Status::lost, fmt::format("the newest scans score {:.2f} nat on average, below {:.2f}", mean_scan_nat_,
                                      options_.lost_scan_nat)};
  const bool doubt = estimate.probability * (1 - now.kidnapped) <= options_.localized_probability;
  if (was_localized_ && same && doubt && held_.weight > 0)
    return {Status::lost,
            fmt::format("the newest scans do not fit here: kidnapped with probability {:.3f}, not below {:.3f}",
                        now.kidnapped, 1 - options_.localized_probability)};
  if (!doubt && held_.weight > 0 && unbroken_ < options_.localized_weight)
    return {unproven(estimate),
            fmt::format("{:.2f} of {:.2f} pieces of new evidence ago the scans or the odometry broke off from those "
                        "before: the robot may have been kidnapped",
                        unbroken_, options_.localized_weight)};
  const double asked = weight_asked(now.unmapped_walls_m);
  std::string other_map = why_not_this_map();
  const bool proven = held_.weight >= asked && !doubt && other_map.empty();
  if (proven && !localized() && held_.nat <= 0) return {unproven(estimate), why_not_for()};
  if (std::string vague = proven ? why_vague(estimate.covariance) : ""; !vague.empty())
    return {unproven(estimate), std::move(vague)};
  const Status status = proven ? Status::localized : unproven(estimate);
  if (held_.weight > 0 && !other_map.empty()) return {status, std::move(other_map)};
  if (held_.weight > 0) return {status, why_held(asked, now.unmapped_walls_m)};
  return {status, why_unsure(same, estimate.probability * (1 - now.kidnapped))};
}

std::string StatusEstimator::why_not_this_map() const {
  if (agreement_.share() < options_.localized_least_agreement)
    return fmt::format(
        "{:.0f} % of the beams that the map speaks about pass through what it has: is it the map of this building?",
        100 * (1 - agreement_.share()));
  if (drive_agreement_.share() < options_.localized_drive_agreement)
    return fmt::format(
        "on the last metres {:.0f} % of the beams that the map speaks about pass through what it has, and at most "
        "{:.0f} % may, wherever the best place was: does the map show the building as it is?",
        100 * (1 - drive_agreement_.share()), 100 * (1 - options_.localized_drive_agreement));
  return "";
}

std::string StatusEstimator::why_not_for() const {
  return fmt::format(
      "the {:.2f} pieces of new evidence since the place is probable say nothing for it: {:.1f} nat, not above 0",
      held_.weight, held_.nat);
}

std::string StatusEstimator::why_vague(const Eigen::Matrix3d& covariance) const {
  const double off_m = kSigmas * largest_sigma(covariance.topLeftCorner<2, 2>()),
               off_rad = kSigmas * std::sqrt(covariance(2, 2));
  if (off_m <= options_.localized_within_m && off_rad <= options_.localized_within_rad) return "";
  return fmt::format(
      "the place is known, the pose only within {:.2f} m and {:.1f} degrees, and should be within {:.2f} m and {:.1f} "
      "degrees: little has been seen lately that fixes it",
      off_m, degrees(off_rad), options_.localized_within_m, degrees(options_.localized_within_rad));
}

std::string StatusEstimator::why_unsure(bool same, double probability) const {
  const bool probable = probability > options_.localized_probability;
  if (!probable)
    return fmt::format("the probability is {:.3f}, not above {:.3f}", rounded_down(probability),
                       options_.localized_probability);
  if (!same) return "the best place has just changed";
  return fmt::format(
      "another place explains what was seen nearly as well: its evidence is {:.1f} nat less "
      "of {:.1f}, and should be {:.1f} less",
      lead_.nat, lead_.own_nat, lead_asked_nat());
}

std::string StatusEstimator::why_held(double asked, double unmapped_walls_m) const {
  const std::string held =
      fmt::format("the probability that is asked for has held here for {:.2f} of {:.2f} pieces of new evidence",
                  held_.weight, asked);
  if (asked <= options_.localized_weight) return held;
  std::string why;
  if (unmapped_walls_m > options_.localized_unmapped_m)
    why =
        fmt::format(", so many because {:.1f} m of straight walls that were seen are not on the map", unmapped_walls_m);
  if (agreement_.share() < options_.localized_agreement)
    why += fmt::format(", {} {:.0f} % of the beams that the map speaks about pass through what it has",
                       why.empty() ? "so many because" : "and", 100 * (1 - agreement_.share()));
  return held + why;
}

Status StatusEstimator::while_contradicted(const PoseEstimate& estimate) const {
  return was_localized_ ? Status::lost : unproven(estimate);
}

PoseEstimate StatusEstimator::estimate(const std::vector<Live>& alive, const Pose2& T_local_base, double stamp_s,
                                       const Circumstances& now) {
  PoseEstimate estimate;
  estimate.stamp_s = stamp_s;
  estimate.hypotheses = static_cast<int>(alive.size());
  none_nat_ =
      kept_share(now.tempering_weight, evidence_memory_) * none_nat_ + now.tempering_weight * options_.none_scan_nat;
  believe(alive);
  estimate.none = belief_.none;
  if (alive.empty()) {
    held_ = {};
    estimate.status = was_localized_ ? Status::lost : Status::searching;
    belief_.why = "no hypothesis is left";
    last_ = estimate;
    return estimate;
  }
  estimate.has_pose = true;
  estimate.best = alive.front().hypothesis.id;
  estimate.T_map_base = alive.front().hypothesis.T_map_local * T_local_base;
  estimate.covariance = alive.front().pose.covariance();
  weigh(alive, T_local_base, estimate);
  Judgement judged = judge(alive.front(), T_local_base, estimate, now);
  estimate.status = judged.status;
  belief_.why = std::move(judged.why);
  if (contradiction_.empty())
    map_doubt_.add(drive_agreement_.share(), now.tempering_weight, estimate.status == Status::localized);
  reckon_with(now.kidnapped, estimate);
  was_localized_ = was_localized_ || estimate.status == Status::localized;
  T_map_local_ = alive.front().hypothesis.T_map_local;
  last_ = estimate;
  return estimate;
}

/// All of them are wrong, too, if the robot was kidnapped.
void StatusEstimator::reckon_with(double kidnapped, PoseEstimate& estimate) {
  for (double& probability : belief_.hypotheses) probability *= 1 - kidnapped;
  belief_.none = kidnapped + (1 - kidnapped) * belief_.none;
  estimate.none = belief_.none;
  estimate.probability *= 1 - kidnapped;
  for (auto& alternative : estimate.alternatives) alternative.probability *= 1 - kidnapped;
}

PoseEstimate StatusEstimator::at(double stamp_s, const Pose2& T_local_base) const {
  PoseEstimate estimate = last_;
  estimate.stamp_s = stamp_s;
  if (!last_.has_pose) return estimate;
  if (!contradiction_.empty() && last_.status == Status::localized) estimate.status = Status::lost;
  estimate.T_map_base = T_map_local_ * T_local_base;
  const Pose2 T_last_now = last_.T_map_base.inverse() * estimate.T_map_base;  // as driven, whichever way one looks
  for (auto& alternative : estimate.alternatives) alternative.T_map_base = alternative.T_map_base * T_last_now;
  return estimate;
}

}  // namespace opal
