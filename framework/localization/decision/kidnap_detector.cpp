#include "localization/decision/kidnap_detector.hpp"

#include <algorithm>
#include <cmath>

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
  is_broken_ = seen.match_share < kBrokenShare * usual_share_;
  constexpr double kShareMemory = 0.8;
  usual_share_ = kShareMemory * usual_share_ + (1 - kShareMemory) * seen.match_share;
  if (seen.match_share < kContinuingShare) discontinued_ = seen.keyframe;
  if (seen.established || suspicion_nat_ > 0)
    suspicion_nat_ = std::clamp(suspicion_nat_ + wanted_nat() - seen.scan_nat, 0.0, kMostSuspicion_nat);
  if (suspicion_nat_ == 0) {
    constexpr double kMemory = 0.9;
    usual_nat_ = kMemory * usual_nat_ + (1 - kMemory) * seen.scan_nat;
    last_good_ = {seen.keyframe, seen.gathered_nat};
  } else {
    last_good_.nat *= 1 - seen.tempering_weight * (1 - evidence_memory_);
  }
}

void KidnapDetector::reset() {
  suspicion_nat_ = 0;
  usual_nat_ = 0;
  usual_share_ = 0;
  is_broken_ = false;
  last_good_ = {};
  discontinued_ = {};
}

double KidnapDetector::share_of_usual_nat() const { return std::max(options_.scan_nat, kDrop * usual_nat_); }

double KidnapDetector::wanted_nat() const { return discontinued() ? share_of_usual_nat() : options_.scan_nat; }

double KidnapDetector::probability() const {
  const double prior_nat = discontinued() ? options_.prior_nat : kUnseenPrior_nat;
  return 1 / (1 + std::exp(-(suspicion_nat_ + prior_nat)));
}

bool KidnapDetector::alarming(double scan_nat) const { return scan_nat < share_of_usual_nat() - options_.alarm_nat; }

std::optional<RetrospectiveVerification::Takeover> KidnapDetector::suspected() const {
  if (suspicion_nat_ < kSearchFrom_nat || !discontinued()) return std::nullopt;
  return RetrospectiveVerification::Takeover{last_good_.keyframe,
                                             last_good_.nat + options_.prior_nat + kPlacePrior_nat};
}

}  // namespace opal
