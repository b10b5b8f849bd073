#include "localization/decision/kidnap_detector.hpp"

#include <opal/localization/scoring/scorer_memory.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace opal {
namespace {

// A scan of whose points fewer lie on what was seen before does not continue it: a robot that only drives sees most
// again.
constexpr double kContinuingShare = 0.5;
// A scan of which a smaller share than this, times the usual one, lies on what was seen before breaks off from it.
// Robots that only drive meet this in one of 300 scans, robots that are kidnapped nearly always.
constexpr double kBrokenShare = 0.5;
// A scan that does not continue those before says at least this share of what they said, on average; a place that looks
// alike by chance says less.
constexpr double kDrop = 0.5;
// Log prior of a kidnapping though every scan continued those before: who is kidnapped sees something else.
constexpr double kUnseenPrior_nat = -10;
// Log prior of one place among all where the robot may have been put down: 20,000 places.
constexpr double kPlacePrior_nat = -10;
// Suspicion grows up to this, so that good scans can take it back.
constexpr double kMostSuspicion_nat = 8;
// Suspicion from which on the whole map is searched: 20 to 1.
constexpr double kSearchFrom_nat = 3;

}  // namespace

void KidnapDetector::add(const Evidence& seen) {
  const bool fell = agreement_fall_.add(seen.agreement), doubted = is_doubted(seen);
  if (fell || doubted || seen.match_share < kContinuingShare) {
    discontinued_ = seen.keyframe;
    since_discontinued_ = 0;
  }
  since_discontinued_ += seen.tempering_weight;
  is_broken_ = doubted || seen.match_share < kBrokenShare * usual_share_;
  constexpr double kShareMemory = 0.8;
  usual_share_ = kShareMemory * usual_share_ + (1 - kShareMemory) * seen.match_share;
  turn_to(seen);
  // Without a break, scans taken close together miss the same walls: they say little more than one of them does.
  const double share = discontinued(watch_) ? 1 : seen.tempering_weight;
  const double missing_nat = share * (wanted_nat() - seen.scan_nat);
  if (seen.established || watch_.suspicion_nat > 0)
    watch_.suspicion_nat = std::clamp(watch_.suspicion_nat + missing_nat, 0.0, kMostSuspicion_nat);
  const double kept = kept_share(seen.tempering_weight, evidence_memory_);
  const bool on_probation = discontinued(watch_) && since_discontinued_ < options_.doubted_weight;
  if (watch_.suspicion_nat == 0 && !on_probation) {
    constexpr double kMemory = 0.9;
    watch_.usual_nat = kMemory * watch_.usual_nat + (1 - kMemory) * seen.scan_nat;
    watch_.last_good = {seen.keyframe, seen.gathered_nat};
  } else {
    watch_.last_good.nat *= kept;
  }
  before_.last_good.nat *= kept;
}

/// What another place used to say, and that it no longer fits, is nothing against this one.
void KidnapDetector::turn_to(const Evidence& seen) {
  if (seen.kidnapped_after == watch_.kidnapped_after) return;
  std::swap(watch_, before_);
  if (seen.kidnapped_after == watch_.kidnapped_after) return;
  watch_ = {};
  watch_.kidnapped_after = seen.kidnapped_after;
  watch_.last_good = {seen.keyframe, seen.gathered_nat};
}

void KidnapDetector::settle(double inherited_nat) {
  watch_.kidnapped_after = {};
  watch_.last_good.nat -= inherited_nat;
  before_ = {};
}

void KidnapDetector::reset() {
  watch_ = before_ = {};
  usual_share_ = 0;
  agreement_fall_.clear();
  is_broken_ = false;
  discontinued_ = {};
  since_discontinued_ = 0;
}

bool KidnapDetector::is_doubted(const Evidence& seen) const {
  return seen.match_share < options_.doubted_share * usual_share_ && seen.scan_nat < share_of_usual_nat();
}

bool KidnapDetector::discontinued(const Watch& watch) const {
  return discontinued_.exists() && discontinued_.next() >= watch.last_good.keyframe;
}

double KidnapDetector::share_of_usual_nat() const { return std::max(options_.scan_nat, kDrop * watch_.usual_nat); }

double KidnapDetector::wanted_nat() const { return discontinued(watch_) ? share_of_usual_nat() : options_.scan_nat; }

double KidnapDetector::probability() const {
  const double prior_nat = discontinued(watch_) ? options_.prior_nat : kUnseenPrior_nat;
  return 1 / (1 + std::exp(-(watch_.suspicion_nat + prior_nat)));
}

bool KidnapDetector::alarming(double scan_nat) const { return scan_nat < share_of_usual_nat() - options_.alarm_nat; }

bool KidnapDetector::is_suspicious(const Watch& watch) const {
  return watch.suspicion_nat >= kSearchFrom_nat && discontinued(watch);
}

std::optional<RetrospectiveVerification::Takeover> KidnapDetector::suspected() const {
  const auto from = [this](const Watch& watch) {
    return RetrospectiveVerification::Takeover{watch.last_good.keyframe,
                                               watch.last_good.nat + options_.prior_nat + kPlacePrior_nat};
  };
  if (is_suspicious(watch_)) return from(watch_);
  if (watch_.kidnapped_after.exists() && is_suspicious(before_)) return from(before_);
  return std::nullopt;
}

}  // namespace opal
